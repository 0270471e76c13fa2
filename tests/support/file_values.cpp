// Makes property values. A value's kind determines the name of its XML element.
#include "support/file_values.h"

#include <memory>

namespace obby::test {

FileValue text(std::string value) { return {FileKind::String, std::move(value), "string"}; }
FileValue source(std::string value) {
  return {FileKind::String, std::move(value), "ProtectedString"};
}
FileValue blob(std::string bytes) { return {FileKind::String, std::move(bytes), "BinaryString"}; }
FileValue address(std::string uri) { return {FileKind::String, std::move(uri), "ContentId"}; }
FileValue content(std::string uri) { return {FileKind::Content, std::move(uri), "Content"}; }
FileValue shared(std::string bytes) {
  return {FileKind::SharedString, SharedBlob{std::make_shared<const std::string>(std::move(bytes))},
          "SharedString"};
}
FileValue flag(bool value) { return {FileKind::Bool, value, "bool"}; }
FileValue int32(int32_t value) { return {FileKind::Int32, int64_t{value}, "int"}; }
FileValue int64(int64_t value) { return {FileKind::Int64, value, "int64"}; }
FileValue float32(float value) { return {FileKind::Float32, static_cast<double>(value), "float"}; }
FileValue float64(double value) { return {FileKind::Float64, value, "double"}; }
FileValue token(uint32_t value) { return {FileKind::Enum, EnumItem{value, {}}, "token"}; }
FileValue vec3(float x, float y, float z) { return {FileKind::Vector3, Vec3{x, y, z}, "Vector3"}; }
FileValue cframe(CFrame value) { return {FileKind::CFrame, value, "CoordinateFrame"}; }
FileValue cframe(float x, float y, float z) { return cframe(CFrame{{x, y, z}, {}}); }
FileValue optionalCFrame(std::optional<CFrame> value) {
  return {FileKind::OptionalCFrame, value ? Value{*value} : Value{}, "OptionalCoordinateFrame"};
}
FileValue color3(ColorRgb value) { return {FileKind::Color3, value, "Color3"}; }
FileValue color8(ColorRgb value) { return {FileKind::Color3uint8, value, "Color3uint8"}; }
FileValue brickNumber(uint32_t number) { return {FileKind::BrickColor, int64_t{number}, "int"}; }
FileValue ref(InstanceId target) { return {FileKind::Ref, Ref{target}, "Ref"}; }
FileValue physical(PhysicalProperties value, bool acoustics) {
  return {FileKind::PhysicalProperties, value, "PhysicalProperties", acoustics};
}
FileValue uniqueId(std::string hex) { return {FileKind::UniqueId, std::move(hex), "UniqueId"}; }
FileValue udim(float scale, int32_t offset) {
  return {FileKind::UDim, UDim{scale, offset}, "UDim"};
}
FileValue range(float min, float max) {
  return {FileKind::NumberRange, NumberRange{min, max}, "NumberRange"};
}
FileValue capabilities(int64_t bits) {
  return {FileKind::SecurityCapabilities, bits, "SecurityCapabilities"};
}

FileValue unread(FileKind kind) {
  switch (kind) {
    case FileKind::UDim2: return {kind, {}, "UDim2"};
    case FileKind::Ray: return {kind, {}, "Ray"};
    case FileKind::Faces: return {kind, {}, "Faces"};
    case FileKind::Axes: return {kind, {}, "Axes"};
    case FileKind::Vector2: return {kind, {}, "Vector2"};
    case FileKind::Vector3int16: return {kind, {}, "Vector3int16"};
    case FileKind::NumberSequence: return {kind, {}, "NumberSequence"};
    case FileKind::ColorSequence: return {kind, {}, "ColorSequence"};
    case FileKind::Rect: return {kind, {}, "Rect2D"};
    default: return {FileKind::Font, {}, "Font"};
  }
}

FileValue emptyOf(const FileValue& like) {
  FileValue out = like;
  const bool absent = like.kind == FileKind::OptionalCFrame;
  std::visit(
      [&](const auto& value) {
        using T = std::decay_t<decltype(value)>;
        if (absent) {
          out.value = {};
        } else if constexpr (std::is_same_v<T, SharedBlob>) {
          out.value = SharedBlob{std::make_shared<const std::string>()};
        } else {
          out.value = T{};
        }
      },
      like.value);
  if (like.kind == FileKind::UniqueId) out.value = std::string(32, '0');
  return out;
}

}  // namespace obby::test
