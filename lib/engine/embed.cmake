# Writes OUT: each file of FILES as an array of bytes, and embeddedFile() that finds it by name.
set(arrays "") 
set(rows "")
set(index 0)
foreach(file IN LISTS FILES)
  get_filename_component(name ${file} NAME)
  string(REGEX REPLACE "\\.luau$" "" name ${name})
  file(READ ${file} hex HEX)
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${hex}")
  string(APPEND arrays "const unsigned char kFile${index}[] = {${bytes}0};\n")
  string(APPEND rows "    {\"${name}\", reinterpret_cast<const char*>(kFile${index}), sizeof kFile${index} - 1},\n")
  math(EXPR index "${index} + 1")
endforeach()
file(WRITE ${OUT} "#include \"engine/embedded.h\"

namespace obby::engine {
namespace {
${arrays}
struct Row {
  std::string_view name;
  const char* bytes;
  unsigned long size;
};
const Row kRows[] = {
${rows}};
}  // namespace

std::string_view embeddedFile(std::string_view name) {
  for (const Row& row : kRows)
    if (row.name == name) return {row.bytes, row.size};
  return {};
}
}  // namespace obby::engine
")
