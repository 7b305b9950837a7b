#include "tests/audit/sealed_package.hpp"

#include "core/file.hpp"

namespace fs = std::filesystem;

namespace rva::test {

Contents contents_of(const fs::path& folder) {
  Contents contents;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file())
      contents[entry.path().lexically_relative(folder).native()] = read_text_file(entry.path());
  return contents;
}

void write_contents(const fs::path& folder, const Contents& contents) {
  for (const auto& [file, text] : contents) {
    fs::create_directories((folder / file).parent_path());
    write_file(folder / file, text);
  }
}

Contents SealedPackage::payload() {
  return {{"data/inspection.json", "{\"format\": \"rva-inspection\"}\n"},
          {"data/initial/000/depth/000000.png", "pixels before"},
          {"data/final/000/depth/000000.png", "pixels after"},
          {"data/empty", ""}};
}

SealedPackage::SealedPackage() {
  append_to_log(log_, leaf_hash("earlier"), log_key_);
  append_to_log(log_, leaf_hash("another"), log_key_);
  seal(package_, payload(), signing());
}

KnownFromElsewhere SealedPackage::known() const {
  const PackageSigning all = signing();
  KnownFromElsewhere known;
  for (const SigningKey& key : all.signers) known.keys.push_back(key.public_key());
  known.keys.push_back(log_key_.public_key());
  known.log = log_;
  return known;
}

void SealedPackage::seal(const fs::path& package, const Contents& payload,
                         const PackageSigning& signing) const {
  write_contents(package, payload);
  seal_package(package, {12, "N1", "bay", "W1"}, "2026-01-01T00:00:00.000Z", signing);
}

}  // namespace rva::test
