// Fills records by reflection, so new fields of the schema are tested automatically.
#pragma once

#include <capnp/dynamic.h>

#include <cmath>
#include <cstring>
#include <string>

#include "base/random.h"
#include "io/record.h"

namespace obby::test {

class RecordFiller {
 public:
  // `chance` is the probability that a field is set; `longest` is the maximum length of lists.
  RecordFiller(uint64_t seed, float chance, uint32_t longest)
      : random_(seed, 7), chance_(chance), longest_(longest) {}

  io::RecordBuilder fill(io::Kind kind) {
    io::RecordBuilder out;
    capnp::DynamicStruct::Builder root(out.root());
    const auto field = capnp::StructSchema(root.getSchema()).getFields()[uint32_t(kind)];
    fields(root.init(field).as<capnp::DynamicStruct>());
    return out;
  }

 private:
  void fields(capnp::DynamicStruct::Builder out) {
    for (auto field : out.getSchema().getFields()) {
      if (random_.unit() >= chance_) continue;
      const auto type = field.getType();
      if (type.isStruct()) {
        fields(out.init(field).as<capnp::DynamicStruct>());
      } else if (type.isList()) {
        list(type.asList(), out.init(field, random_.below(longest_ + 1)).as<capnp::DynamicList>());
      } else if (type.isText()) {
        const std::string value = text();
        out.set(field, capnp::Text::Reader(value.c_str(), value.size()));
      } else {
        range_ = rangeOf(field);
        out.set(field, scalar(type));
        range_ = {};
      }
    }
  }

  void list(capnp::ListSchema schema, capnp::DynamicList::Builder out) {
    const auto type = schema.getElementType();
    for (uint32_t i = 0; i < out.size(); i++) {
      if (type.isStruct()) {
        fields(out[i].as<capnp::DynamicStruct>());
      } else if (type.isText()) {
        const std::string value = text();
        out.set(i, capnp::Text::Reader(value.c_str(), value.size()));
      } else {
        out.set(i, scalar(type));
      }
    }
  }

  struct Range {
    bool set = false;
    double min = 0, max = 0;
  };

  static Range rangeOf(capnp::StructSchema::Field field) {
    for (auto annotation : field.getProto().getAnnotations()) {
      if (annotation.getId() != 0xd2a9f8e3b7c61a55) continue;
      const auto interval = annotation.getValue().getStruct().getAs<schema::Interval>();
      return {true, interval.getMin(), interval.getMax()};
    }
    return {};
  }

  capnp::DynamicValue::Reader scalar(capnp::Type type) {
    switch (type.which()) {
      case capnp::schema::Type::BOOL: return random_.below(2) == 1;
      case capnp::schema::Type::FLOAT32: return real32();
      case capnp::schema::Type::FLOAT64: return real64();
      case capnp::schema::Type::ENUM: {
        const auto names = type.asEnum().getEnumerants();
        return capnp::DynamicEnum(names[random_.below(names.size())]);
      }
      case capnp::schema::Type::INT32: return int64_t(int32_t(random_.next()));
      case capnp::schema::Type::UINT8: return uint64_t(random_.below(256));
      case capnp::schema::Type::UINT16:
        if (range_.set) return uint64_t(range_.min);
        return uint64_t(random_.below(65536));
      case capnp::schema::Type::UINT32: return uint64_t(random_.next());
      case capnp::schema::Type::UINT64: return uint64_t(random_.next()) << 32 | random_.next();
      default: break;
    }
    KJ_FAIL_ASSERT("a type that the generator does not know");
  }

  // Returns an arbitrary finite bit pattern half of the time, otherwise a plain number, sometimes
  // -0.
  float real32() {
    if (range_.set)
      return float(range_.min + (range_.max - range_.min) * 0.998 * double(random_.unit()));
    if (random_.below(16) == 0) return -0.0f;
    if (random_.below(2) == 0) return float(random_.below(4001)) / 8.0f - 250.0f;
    const uint32_t bits = random_.next();
    float value = 0;
    std::memcpy(&value, &bits, 4);
    return std::isfinite(value) ? value : 0.1f;
  }

  double real64() {
    const uint64_t bits = uint64_t(random_.next()) << 32 | random_.next();
    double value = 0;
    std::memcpy(&value, &bits, 8);
    return std::isfinite(value) ? value : -0.0;
  }

  // Returns letters, quotes, control characters, multibyte characters and NULs.
  std::string text() {
    static const std::string kPieces[] = {"a",
                                          "Z",
                                          "\"",
                                          "\\",
                                          "\n",
                                          "\x01",
                                          "\x7f",
                                          "\xc3\xa9",
                                          "\xe2\x82\xac",
                                          "\xf0\x9f\x98\x80",
                                          std::string(1, '\0'),
                                          "/"};
    std::string out;
    for (uint32_t n = random_.below(9); n > 0; n--) out += kPieces[random_.below(12)];
    return out;
  }

  Random random_;
  float chance_;
  uint32_t longest_;
  Range range_;
};

inline constexpr uint32_t kKinds = 10;

}  // namespace obby::test
