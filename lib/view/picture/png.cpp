#include "view/picture/png.h"

#include <png.h>

namespace obby::view {

Result<std::string> pngOf(const Image& image) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = png_uint_32(image.width);
  header.height = png_uint_32(image.height);
  header.format = PNG_FORMAT_RGB;
  static_assert(sizeof(Rgb) == 3);
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(header);
  std::string out(size, '\0');
  if (!png_image_write_to_memory(&header, out.data(), &size, 0, image.pixels.data(), 0, nullptr))
    return makeError(std::string("cannot encode the picture: ") + header.message);
  out.resize(size);
  return out;
}

}  // namespace obby::view
