// Property values as place files store them, of every kind in the formats, including kinds that a
// Document drops.
#pragma once

#include <optional>
#include <string>

#include "engine/document.h"

namespace obby::test {

// The enumerators' values are the kinds' numbers in the binary format.
enum class FileKind : uint8_t {
  String = 0x01,
  Bool = 0x02,
  Int32 = 0x03,
  Float32 = 0x04,
  Float64 = 0x05,
  UDim = 0x06,
  UDim2 = 0x07,
  Ray = 0x08,
  Faces = 0x09,
  Axes = 0x0a,
  BrickColor = 0x0b,
  Color3 = 0x0c,
  Vector2 = 0x0d,
  Vector3 = 0x0e,
  CFrame = 0x10,
  Enum = 0x12,
  Ref = 0x13,
  Vector3int16 = 0x14,
  NumberSequence = 0x15,
  ColorSequence = 0x16,
  NumberRange = 0x17,
  Rect = 0x18,
  PhysicalProperties = 0x19,
  Color3uint8 = 0x1a,
  Int64 = 0x1b,
  SharedString = 0x1c,
  Bytecode = 0x1d,
  OptionalCFrame = 0x1e,
  UniqueId = 0x1f,
  Font = 0x20,
  SecurityCapabilities = 0x21,
  Content = 0x22,
};

struct FileValue {
  FileKind kind = FileKind::String;
  // The Document's value; monostate if the Document drops the kind, or for an absent
  // OptionalCFrame.
  Value value;
  std::string xmlElement;  // the element's name in XML
  bool acoustics = false;  // PhysicalProperties: true if the flag for acoustic absorption is set
};

FileValue text(std::string value);    // <string>
FileValue source(std::string value);  // <ProtectedString>
FileValue blob(std::string bytes);    // <BinaryString>
FileValue address(std::string uri);   // ContentId
FileValue content(std::string uri);   // Content; empty: none
FileValue shared(std::string bytes);  // SharedString
FileValue flag(bool value);
FileValue int32(int32_t value);
FileValue int64(int64_t value);
FileValue float32(float value);
FileValue float64(double value);
FileValue token(uint32_t value);  // an enum item
FileValue vec3(float x, float y, float z);
FileValue cframe(CFrame value);
FileValue cframe(float x, float y, float z);
FileValue optionalCFrame(std::optional<CFrame> value);
FileValue color3(ColorRgb value);
FileValue color8(ColorRgb value);
FileValue brickNumber(uint32_t number);  // a BrickColor
FileValue ref(InstanceId target);
FileValue physical(PhysicalProperties value, bool acoustics = false);
FileValue uniqueId(std::string hex);  // 32 digits, as in XML
FileValue udim(float scale, int32_t offset);
FileValue range(float min, float max);
FileValue capabilities(int64_t bits);
// Returns a sample of a kind that a Document does not keep (UDim2, Ray, Faces, ...).
FileValue unread(FileKind kind);

// Returns the value that the format stores for an instance without a property that others of its
// class have.
FileValue emptyOf(const FileValue& like);

}  // namespace obby::test
