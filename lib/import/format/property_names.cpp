// Lists the spellings of properties, and the properties dropped because no level can depend on
// them.
#include "import/format/property_names.h"

#include <algorithm>
#include <array>

#include "engine/classes/class_defaults.h"
#include "engine/values/brick_colors.h"

namespace obby::importer {
namespace {

struct Spelling {
  std::string_view inFile, name,
      onlyIn;  // class (or its ancestor) that has the spelling; empty: every class
  bool legacy = false;
};

// Rows sorted by the spelling in the file.
constexpr std::array kSpellings = {
    Spelling{"BrickColor", "Color", "BasePart", true},
    Spelling{"Color3uint8", "Color", {}},
    Spelling{"DefinesCapabilities", "Sandboxed", {}},
    Spelling{"Health_XML", "Health", {}},
    Spelling{"MaterialVariantSerialized", "MaterialVariant", {}},
    Spelling{"MeshContent", "MeshId", {}},
    Spelling{"Part0Internal", "Part0", {}},
    Spelling{"Part1Internal", "Part1", {}},
    Spelling{"ScaleFactor", "Scale", "Model"},
    Spelling{"TextureContent", "TextureID", "MeshPart"},
    Spelling{"angularvelocity", "AngularVelocity", {}},
    Spelling{"archivable", "Archivable", {}},
    Spelling{"brickColor", "Color", "BasePart", true},
    Spelling{"cframe", "CFrame", {}},
    Spelling{"formFactor", "FormFactor", {}},
    Spelling{"formFactorRaw", "FormFactor", {}},
    Spelling{"linkedSource", "LinkedSource", {}},
    Spelling{"maxForce", "MaxForce", {}},
    Spelling{"maxHealth", "MaxHealth", {}},
    Spelling{"maxTorque", "MaxTorque", {}},
    Spelling{"position", "Position", {}},
    Spelling{"shape", "Shape", {}},
    Spelling{"size", "Size", {}},
    Spelling{"style", "Style", {}},
    Spelling{"velocity", "Velocity", {}},
};

// Surfaces, render data and editor bookkeeping. Sorted.
constexpr std::array<std::string_view, 46> kDropped = {
    "BackParamA",        "BackParamB",         "BackSurface",
    "BackSurfaceInput",  "BottomParamA",       "BottomParamB",
    "BottomSurface",     "BottomSurfaceInput", "Capabilities",
    "CastShadow",        "ChildData",          "ChildData2",
    "FrontParamA",       "FrontParamB",        "FrontSurface",
    "FrontSurfaceInput", "HistoryId",          "LODData",
    "LeftParamA",        "LeftParamB",         "LeftSurface",
    "LeftSurfaceInput",  "LevelOfDetail",      "MeshData",
    "MeshData2",         "ModelInPrimary",     "ModelMeshCFrame",
    "ModelMeshData",     "ModelMeshSize",      "NeedsPivotMigration",
    "Reflectance",       "RenderFidelity",     "RightParamA",
    "RightParamB",       "RightSurface",       "RightSurfaceInput",
    "RootPriority",      "ScriptGuid",         "SerializedMeshData",
    "SourceAssetId",     "TopParamA",          "TopParamB",
    "TopSurface",        "TopSurfaceInput",    "UsePartColor",
    "VertexCount",
};

}  // namespace

PropertySpelling spellingOf(std::string_view className, std::string_view name) {
  if (std::binary_search(kDropped.begin(), kDropped.end(), name)) return {};
  const auto row = std::lower_bound(
      kSpellings.begin(), kSpellings.end(), name,
      [](const Spelling& spelling, std::string_view wanted) { return spelling.inFile < wanted; });
  const bool known = row != kSpellings.end() && row->inFile == name;
  if (!known || (!row->onlyIn.empty() && !isA(className, row->onlyIn))) {
    return {std::string(name), false};
  }
  return {std::string(row->name), row->legacy};
}

Value normalisedValue(const Value& standard, Value value) {
  if (standard.index() == value.index()) return value;
  if (std::holds_alternative<ColorRgb>(standard)) {
    if (const auto* number = std::get_if<int64_t>(&value)) return brickColor(*number);
    return value;
  }
  return coerceTo(std::move(value), standard);
}

}  // namespace obby::importer
