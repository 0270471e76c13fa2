// Writes the XML format.
#pragma once

#include <string>
#include <vector>

#include "support/place_writer.h"

namespace obby::test {

// Returns an XML place file. The referent of the instance with index i is RBXi.
std::string xmlPlace(const std::vector<PlaceWriter::Entry>& entries);

std::string encodeBase64(const std::string& bytes);

}  // namespace obby::test
