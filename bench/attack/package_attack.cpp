#include "bench/attack/package_attack.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <utility>

#include "audit/checkpoint.hpp"
#include "audit/package_check.hpp"
#include "audit/package_files.hpp"
#include "core/error.hpp"
#include "core/random.hpp"
#include "tests/audit/sealed_package.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

using test::Contents;

std::size_t below(std::size_t count, Random& random) { return random.bits() % count; }

Contents::iterator any_file(Contents& contents, Random& random) {
  return std::next(contents.begin(), static_cast<std::ptrdiff_t>(below(contents.size(), random)));
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size() - 1);
    lines.push_back(text.substr(at, end + 1 - at));
    at = end + 1;
  }
  return lines;
}

// Each changes the contents, or nothing where it does not apply to the file that was drawn.
using Change = void (*)(Contents& contents, Random& random);

void flip_bit(Contents& contents, Random& random) {
  std::string& text = any_file(contents, random)->second;
  if (text.empty()) return;
  char& byte = text[below(text.size(), random)];
  byte = static_cast<char>(byte ^ (1 << below(8, random)));
}

void change_byte(Contents& contents, Random& random) {
  std::string& text = any_file(contents, random)->second;
  if (!text.empty()) text[below(text.size(), random)] = static_cast<char>(random.bits());
}

void truncate(Contents& contents, Random& random) {
  std::string& text = any_file(contents, random)->second;
  if (!text.empty()) text.resize(below(text.size(), random));
}

void insert_byte(Contents& contents, Random& random) {
  std::string& text = any_file(contents, random)->second;
  const char byte = below(2, random) == 0 ? '\n' : static_cast<char>(random.bits());
  text.insert(text.begin() + static_cast<std::ptrdiff_t>(below(text.size() + 1, random)), byte);
}

void reorder_lines(Contents& contents, Random& random) {
  std::string& text = any_file(contents, random)->second;
  std::vector<std::string> lines = lines_of(text);
  if (lines.size() < 2) return;
  std::swap(lines[below(lines.size(), random)], lines[below(lines.size(), random)]);
  text.clear();
  for (const std::string& line : lines) text += line;
}

void exchange_files(Contents& contents, Random& random) {
  std::swap(any_file(contents, random)->second, any_file(contents, random)->second);
}

void remove_file(Contents& contents, Random& random) { contents.erase(any_file(contents, random)); }

void add_file(Contents& contents, Random& random) {
  const std::array<const char*, 4> folders{"", "data/", "signature/", "data/initial/000/depth/"};
  contents[folders[below(folders.size(), random)] + std::string("file-") + std::to_string(random.bits())] =
      std::to_string(random.bits());
}

void rename_file(Contents& contents, Random& random) {
  auto file = contents.extract(any_file(contents, random));
  file.key() += "-" + std::to_string(below(100, random));
  contents.insert(std::move(file));
}

void repeat_line(Contents& contents, Random& random) {
  std::string& text = any_file(contents, random)->second;
  const std::vector<std::string> lines = lines_of(text);
  if (!lines.empty()) text += lines[below(lines.size(), random)];
}

constexpr std::array<std::pair<const char*, Change>, 10> changes_of_files{
    {{"bit", flip_bit},
     {"byte", change_byte},
     {"truncated", truncate},
     {"inserted byte", insert_byte},
     {"reordered lines", reorder_lines},
     {"exchanged files", exchange_files},
     {"removed file", remove_file},
     {"added file", add_file},
     {"renamed file", rename_file},
     {"repeated line", repeat_line}}};

// Writes both manifests again, so that they fit a changed package: an attacker's way to hide the change.
void cover(Contents& contents) {
  FileDigests payload;
  FileDigests tags;
  for (const auto& [file, text] : contents)
    if (file.starts_with(package_file::payload)) payload.emplace(file, sha256(text));
  contents[package_file::manifest] = manifest_text(payload);
  for (const auto& [file, text] : contents)
    if (!payload.contains(file) && file != package_file::tag_manifest) tags.emplace(file, sha256(text));
  contents[package_file::tag_manifest] = manifest_text(tags);
}

// Without waiting for the disk, which nothing here needs.
void write(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << text;
}

class Attack {
 public:
  explicit Attack(std::uint64_t seed) : random_(seed), original_(test::contents_of(package_.path())) {}

  void once() {
    switch (below(20, random_)) {
      case 0:
        return try_log("rolled-back log", below(3, random_), 3);
      case 1:
        return try_log("split view", 3 + below(20, random_), below(3, random_));
      case 2:
        return forgeries_ < most_forgeries ? try_forgery() : once();
      case 3:
        return try_link();
      default:
        return try_files(below(2, random_) == 0);
    }
  }

  [[nodiscard]] AttackedPackage result() && { return std::move(result_); }

 private:
  // Signing a package anew waits for the disk.
  static constexpr std::size_t most_forgeries = 20;

  void try_files(bool covered) {
    const auto& [name, change] = changes_of_files[below(changes_of_files.size(), random_)];
    Contents changed = original_;
    change(changed, random_);
    if (covered) cover(changed);
    if (changed == original_) return once();
    put(original_, changed);
    check(covered ? std::string("covered: ") + name : name, changed);
    put(changed, original_);
  }

  // A log that the log's own key signed, with `size` records of which that at `other` is another one.
  void try_log(const char* name, std::size_t size, std::size_t other) {
    const Contents log = test::contents_of(package_.log());
    std::vector<Digest> leaves = read_log(package_.log(), package_.log_key().public_key()).leaves;
    leaves.resize(size, leaf_hash(std::to_string(random_.bits())));
    if (other < size) leaves[other] = leaf_hash(std::to_string(random_.bits()));
    std::string lines;
    for (const Digest& leaf : leaves) lines += hex_of(bytes_of(leaf)) + '\n';
    write(package_.log() / "leaves.txt", lines);
    write(package_.log() / "checkpoint", signed_checkpoint({size, tree_root(leaves)}, package_.log_key()));
    check(name, {});
    for (const auto& [file, text] : log) write(package_.log() / file, text);
  }

  // Everything signed anew with other keys of the same names.
  void try_forgery() {
    ++forgeries_;
    const SigningKey ann = SigningKey::generate(package_.ann().public_key().name);
    const bool own_log = below(2, random_) == 0;
    PackageSigning signing{{ann}, own_log ? ann : package_.log_key(), package_.scratch() / "log"};
    Contents payload = test::SealedPackage::payload();
    flip_bit(payload, random_);
    package_.seal(package_.scratch() / "package", payload, signing);
    const Contents forged = test::contents_of(package_.scratch() / "package");
    put(original_, forged);
    check("replaced key", forged);
    put(forged, original_);
    fs::remove_all(package_.scratch());
  }

  void try_link() {
    const std::string file = any_file(original_, random_)->first;
    const fs::path aside = package_.path().parent_path() / "aside";
    fs::rename(package_.path() / file, aside);
    fs::create_symlink(aside, package_.path() / file);
    check("symbolic link", {});
    fs::rename(aside, package_.path() / file);
  }

  void put(const Contents& from, const Contents& to) {
    for (const auto& [file, text] : from)
      if (!to.contains(file)) remove(file);
    for (const auto& [file, text] : to)
      if (const auto before = from.find(file); before == from.end() || before->second != text)
        write(package_.path() / file, text);
  }

  // Its folder, too, if it is empty then.
  void remove(const std::string& file) {
    fs::remove(package_.path() / file);
    for (fs::path folder = fs::path(file).parent_path();
         !folder.empty() && fs::is_empty(package_.path() / folder); folder = folder.parent_path())
      fs::remove(package_.path() / folder);
  }

  void check(const std::string& kind, const Contents& changed) {
    try {
      static_cast<void>(check_package(package_.path(), package_.known()));
    } catch (const Error&) {
      ++result_.kinds[kind].found;
      return;
    }
    ++result_.kinds[kind].undetected;
    std::string description = kind + ":";
    for (const auto& [file, text] : changed)
      if (const auto before = original_.find(file); before == original_.end() || before->second != text)
        description += ' ' + file;
    result_.undetected.push_back(std::move(description));
  }

  test::SealedPackage package_;
  Random random_;
  Contents original_;
  std::size_t forgeries_ = 0;
  AttackedPackage result_;
};

}  // namespace

AttackedPackage attack_package(std::size_t changes, std::uint64_t seed) {
  Attack attack(seed);
  for (std::size_t k = 0; k < changes; ++k) attack.once();
  return std::move(attack).result();
}

}  // namespace rva
