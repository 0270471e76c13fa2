// What the reader knows of values and of names of the engine: pure functions.
#pragma once

#include <string>
#include <vector>

#include "import/luau/datum.h"

namespace obby::importer::luau {

// calls.cpp: what instances have to connect handlers to, and the methods that connect them.
bool isSignalName(const std::string& name);
bool isConnect(const std::string& method);

// library.cpp: Vector3, CFrame, TweenInfo, math, string: pure functions of known values.
Datum vectorDatum(Vec3 v);  // of no instance
Datum libraryField(const std::string& path);
Datum libraryCall(const std::string& path, const std::vector<Datum>& arguments);
Datum valueMethod(const Datum& object, const std::string& name,
                  const std::vector<Datum>& arguments);

// colors.cpp: the numbered colour that BrickColor.new gives, the exact one that Color3 makes of
// three channels from 0 to `full`, and those of a part; unknown where the text or the palette does
// not tell, or no part can have it. And a field of either.
Datum colorGiven(const Datum& given);
Datum colorMade(const std::vector<Datum>& channels, double full);
Datum numberedColor(ColorRgb color);
Datum exactColor(ColorRgb color);
bool isColor(const Datum& datum);
Datum colorField(const Library& color, const std::string& name);

// frames.cpp: the properties of a part that say where it is, and its pose once one of them has
// `value`; unknown if that is.
bool isPoseProperty(const std::string& name);
bool setsPlace(const std::string& poseProperty);
bool setsTurn(const std::string& poseProperty);
Datum posed(Pose pose, const std::string& name, const Datum& value);

}  // namespace obby::importer::luau
