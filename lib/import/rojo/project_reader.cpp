// Reads a project file's tree, and the folders and files that its $path names.
#include "import/rojo/project_reader.h"

#include <algorithm>
#include <iterator>

#include "import/format/read_document.h"
#include "import/rojo/file_kinds.h"
#include "import/rojo/globs.h"
#include "import/rojo/instances.h"
#include "import/rojo/project_files.h"

namespace obby::importer::rojo {
namespace {

constexpr int kMaxProjectDepth = 64;                       // max depth of folders and nodes
constexpr size_t kMaxGlob = 1000;                          // characters
constexpr uint64_t kServer = 1, kClient = 2, kPlugin = 3;  // RunContext

constexpr std::string_view kProjectNames[] = {"default.project.json", "default.project.jsonc"};

// Settings for all instances below one project file.
struct Scope {
  fs::path folder;
  std::vector<std::string> ignored;
  bool legacyScripts = true;
  bool mayLeave = false;  // $path may leave the folder: only in the given project file
};

class ProjectReader {
 public:
  explicit ProjectReader(const std::atomic<bool>* stop)
      : files_(stop), builder_(0), made_(builder_) {}

  Result<Project> read(const std::string& path) {
    OBBY_ASSIGN(const fs::path file, projectFileOf(path));
    files_.allow(file.parent_path().empty() ? fs::path(".") : file.parent_path());
    OBBY_ASSIGN(const io::JsonTree tree, json(file));
    const Json root(tree, tree.root());
    Project project;
    project.name = root["name"].text().value_or(nameOf(file));
    OBBY_ASSIGN(const InstanceId id, projectTree(root, file, project.name, true, 0));
    if (id != kNoInstance) builder_.setParent(id, kNoInstance);
    OBBY_ASSIGN(project.document, builder_.finish(path, false));
    project.document.format = "rojo";
    return project;
  }

 private:
  Result<fs::path> projectFileOf(const std::string& path) const {
    if (!files_.isFolder(path)) return fs::path(path);
    for (const std::string_view name : kProjectNames)
      if (files_.isFile(fs::path(path) / name)) return fs::path(path) / name;
    return Error{path,
                 {},
                 {},
                 "cannot read: Is a directory",
                 "name a folder that contains default.project.json"};
  }

  // Returns the name of the file, or of its folder if it is a default project file.
  static std::string nameOf(const fs::path& file) {
    const std::string stem = fileNameOf(file.filename().string()).stem;
    if (stem != "default") return stem;
    const std::string folder = fs::absolute(file).parent_path().filename().string();
    return folder.empty() ? "project" : folder;
  }

  Result<std::string> bytes(const fs::path& file) {
    OBBY_ASSIGN(std::string bytes, files_.read(file));
    builder_.allow(bytes.size());
    return bytes;
  }

  Result<io::JsonTree> json(const fs::path& file) {
    OBBY_ASSIGN(const std::string text, bytes(file));
    auto tree = parseJson(text);
    if (!tree) tree.error().input = file.string();
    return tree;
  }

  // Returns the root, or kNoInstance for a DataModel, whose children are roots of the document.
  Result<InstanceId> projectTree(const Json& root, const fs::path& file, const std::string& name,
                                 bool isGiven, int depth) {
    const Place place{file.string(), {}};
    if (!root.isObject()) return place.error("expected an object, found " + root.describe());
    Scope scope;
    scope.folder = file.parent_path();
    scope.mayLeave = isGiven;
    scope.legacyScripts = root["emitLegacyScripts"].flag().value_or(true);
    for (const auto& [none, glob] : root["globIgnorePaths"].members())
      if (const auto text = glob.text(); text && text->size() <= kMaxGlob)
        scope.ignored.push_back(*text);
    if (root["syncRules"])
      builder_.warn(place.at("syncRules").error("not supported; ignored").text());
    const Json tree = root["tree"];
    if (!tree.isObject()) return place.at("tree").error("expected an object");
    if (!isGiven || tree["$className"].text() != "DataModel")
      return node(tree, name, "", place.at("tree"), scope, depth);
    OBBY_RETURN_IF_ERROR(children(tree, kNoInstance, "DataModel", place.at("tree"), scope, depth));
    return kNoInstance;
  }

  Status children(const Json& json, InstanceId parent, const std::string& parentClass,
                  const Place& place, const Scope& scope, int depth) {
    for (const auto& [name, child] : json.members()) {
      if (name.starts_with('$')) continue;
      const Place at = place.at(name);
      if (!child.isObject()) return at.error("expected an object, found " + child.describe());
      OBBY_ASSIGN(const InstanceId id, node(child, name, parentClass, at, scope, depth + 1));
      if (id != kNoInstance) builder_.setParent(id, parent);
    }
    return {};
  }

  // Returns the instance of a node, or kNoInstance for an optional path that does not exist.
  Result<InstanceId> node(const Json& json, const std::string& name, const std::string& parentClass,
                          const Place& place, const Scope& scope, int depth) {
    if (depth > kMaxProjectDepth) return place.error("nodes are nested deeper than 64 levels");
    const std::string stated = json["$className"].text().value_or("");
    const std::string wanted = stated.empty() ? inferredClass(name, parentClass) : stated;
    InstanceId id = kNoInstance;
    bool isOptional = false;
    if (json["$path"]) {
      OBBY_ASSIGN(id, pathOf(json["$path"], name, place.at("$path"), scope, depth, isOptional));
    }
    if (id == kNoInstance) {
      if (wanted.empty() && isOptional) return kNoInstance;
      if (wanted.empty())
        return place.error("the node has no class",
                           "give it a $className, or a $path that leads to a file");
      OBBY_ASSIGN(id, made_.add(wanted, name, place));
    } else if (made_.classOf(id) == "Folder" && !wanted.empty()) {
      builder_.become(id, wanted);
    } else if (!stated.empty() && stated != made_.classOf(id)) {
      return place.at("$className")
          .error("does not match the $path, which gives a " + made_.classOf(id));
    }
    made_.rename(id, name);
    OBBY_RETURN_IF_ERROR(made_.setProperties(id, json["$properties"], place.at("$properties")));
    OBBY_RETURN_IF_ERROR(made_.setAttributes(id, json["$attributes"], place.at("$attributes")));
    OBBY_RETURN_IF_ERROR(children(json, id, made_.classOf(id), place, scope, depth));
    return id;
  }

  Result<InstanceId> pathOf(const Json& json, const std::string& name, const Place& place,
                            const Scope& scope, int depth, bool& isOptional) {
    const auto optional = json["optional"].text();
    const auto stated = optional ? optional : json.text();
    isOptional = optional.has_value();
    if (!stated) return place.error("expected a path, found " + json.describe());
    const fs::path path = scope.folder / *stated;
    if (scope.mayLeave) files_.allow(path);
    if (!files_.isFolder(path) && !files_.isFile(path)) {
      if (isOptional) return kNoInstance;
      return place.error("there is no file or folder " + path.string());
    }
    OBBY_ASSIGN(const InstanceId id, entry(path, name, scope, depth + 1));
    if (id == kNoInstance) return place.error("no instance can be made of this file or folder");
    return id;
  }

  // Returns the instance made from a file or folder, or kNoInstance if none is made.
  Result<InstanceId> entry(const fs::path& path, const std::string& name, const Scope& scope,
                           int depth) {
    const Place place{path.string(), {}};
    if (depth > kMaxProjectDepth) return place.error("folders are nested deeper than 64 levels");
    if (files_.isFolder(path)) {
      if (!files_.enter(path)) {
        builder_.warn(place.error("the folder contains itself; left out").text());
        return kNoInstance;
      }
      auto id = folder(path, name, scope, depth);
      files_.leave();
      return id;
    }
    const FileName file = fileNameOf(path.filename().string());
    if (!files_.isFile(path) || file.kind == FileKind::none || file.kind == FileKind::meta)
      return kNoInstance;
    OBBY_ASSIGN(const InstanceId id, instanceOf(path, file.kind, name, scope, depth));
    OBBY_RETURN_IF_ERROR(meta(id, path.parent_path() / (file.stem + ".meta.json")));
    return id;
  }

  Result<InstanceId> instanceOf(const fs::path& path, FileKind kind, const std::string& name,
                                const Scope& scope, int depth) {
    const Place place{path.string(), {}};
    if (kind == FileKind::project || kind == FileKind::modelJson || kind == FileKind::json) {
      OBBY_ASSIGN(const io::JsonTree tree, json(path));
      const Json root(tree, tree.root());
      if (kind == FileKind::project) return projectTree(root, path, name, false, depth);
      if (kind == FileKind::modelJson) return made_.addModel(root, name, place);
      return withText("ModuleScript", name, "Source", luauOf(root), place);
    }
    OBBY_ASSIGN(std::string content, bytes(path));
    if (kind == FileKind::model) return model(content, name, place);
    if (kind == FileKind::text) return withText("StringValue", name, "Value", content, place);
    if (kind == FileKind::table)
      return withText("LocalizationTable", name, "Contents", content, place);
    if (kind == FileKind::data) {
      builder_.warn(place
                        .error("this format is not parsed; the file becomes a ModuleScript that "
                               "returns its text")
                        .text());
      return withText("ModuleScript", name, "Source", luauOf(content), place);
    }
    return script(kind, name, withUnixLines(std::move(content)), place, scope);
  }

  Result<InstanceId> withText(const char* className, const std::string& name, const char* property,
                              std::string text, const Place& place) {
    OBBY_ASSIGN(const InstanceId id, made_.add(className, name, place));
    builder_.set(id, property, std::move(text));
    return id;
  }

  Result<InstanceId> script(FileKind kind, const std::string& name, std::string source,
                            const Place& place, const Scope& scope) {
    const bool isClient = kind == FileKind::clientScript;
    const bool isLocal = isClient && scope.legacyScripts;
    const char* className = kind == FileKind::moduleScript ? "ModuleScript"
                            : isLocal                      ? "LocalScript"
                                                           : "Script";
    OBBY_ASSIGN(const InstanceId id, withText(className, name, "Source", std::move(source), place));
    const uint64_t context = kind == FileKind::pluginScript ? kPlugin
                             : scope.legacyScripts          ? 0
                             : isClient                     ? kClient
                                                            : kServer;
    if (context != 0 && kind != FileKind::moduleScript)
      builder_.set(id, "RunContext", EnumItem{uint32_t(context), {}});
    return id;
  }

  Result<InstanceId> model(const std::string& content, const std::string& name,
                           const Place& place) {
    OBBY_ASSIGN(Document document, readDocument(content, place.file));
    const std::vector<InstanceId> roots = builder_.graft(std::move(document));
    if (roots.size() == 1) {
      made_.rename(roots[0], name);
      return roots[0];
    }
    OBBY_ASSIGN(const InstanceId id, made_.add("Folder", name, place));
    for (const InstanceId root : roots) builder_.setParent(root, id);
    return id;
  }

  Result<InstanceId> folder(const fs::path& path, const std::string& name, const Scope& scope,
                            int depth) {
    OBBY_ASSIGN(const std::vector<std::string> names, files_.list(path));
    const auto has = [&](std::string_view wanted) {
      return std::binary_search(names.begin(), names.end(), wanted);
    };
    for (const std::string_view project : kProjectNames)
      if (has(project)) return entry(path / project, name, scope, depth + 1);
    const auto init = std::find_if(std::begin(kInitFiles), std::end(kInitFiles), has);
    InstanceId id = kNoInstance;
    const Place place{path.string(), {}};
    if (init == std::end(kInitFiles)) {
      OBBY_ASSIGN(id, made_.add("Folder", name, place));
    } else {
      OBBY_ASSIGN(id, instanceOf(path / *init, fileNameOf(*init).kind, name, scope, depth));
    }
    OBBY_RETURN_IF_ERROR(meta(id, path / "init.meta.json"));
    for (const std::string& child : names) {
      if (isOfFolder(child)) continue;
      const fs::path at = path / child;
      if (isIgnored(scope.ignored, at.lexically_relative(scope.folder).generic_string())) continue;
      const std::string stem = fileNameOf(child).stem;
      OBBY_ASSIGN(const InstanceId below,
                  entry(at, stem.empty() || files_.isFolder(at) ? child : stem, scope, depth + 1));
      if (below != kNoInstance) builder_.setParent(below, id);
    }
    return id;
  }

  // Applies the settings file next to a file or in a folder, if there is one.
  Status meta(InstanceId id, fs::path file) {
    if (!files_.isFile(file)) file += "c";
    if (!files_.isFile(file)) return {};
    OBBY_ASSIGN(const io::JsonTree tree, json(file));
    const Json root(tree, tree.root());
    const Place place{file.string(), {}};
    const auto className = root["className"].text();
    if (className && made_.classOf(id) == "Folder") builder_.become(id, *className);
    OBBY_RETURN_IF_ERROR(made_.setProperties(id, root["properties"], place.at("properties")));
    return made_.setAttributes(id, root["attributes"], place.at("attributes"));
  }

  ProjectFiles files_;
  DocumentBuilder builder_;
  Instances made_;
};

}  // namespace

bool isProject(const std::string& path) {
  std::error_code error;
  return fileNameOf(path.substr(path.find_last_of('/') + 1)).kind == FileKind::project ||
         fs::is_directory(path, error);
}

Result<Project> readProject(const std::string& path, const std::atomic<bool>* stop) {
  return ProjectReader(stop).read(path);
}

}  // namespace obby::importer::rojo
