/// Mutations of FBX files that keep their records whole: what changes is what the records say. Bytes inserted or
/// deleted anywhere would only ever meet the check of the records' sizes.
#pragma once

#include <array>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "interchange/fbx_records.h"

namespace limbwave::test {

class FbxMutator {
 public:
  explicit FbxMutator(unsigned seed) : random_(seed) {}

  /// The file with one to four changes; empty when its records cannot be parsed.
  std::string mutated(const std::string& bytes);

 private:
  struct Node {
    std::string name;
    std::vector<std::string> values;  ///< As they stand in a file.
    std::vector<Node> children;
  };

  static Node tree_of(const interchange::FbxRecord& record);
  static void all_below(Node& node, std::vector<Node*>& list);
  static void append(const Node& node, std::string& out);
  std::size_t pick(std::size_t count) { return random_() % count; }
  void change(Node& root);
  void change_value(std::string& value, const std::vector<Node*>& all);
  void change_array(std::string& value);
  double odd_number();

  std::mt19937 random_;
};

}  // namespace limbwave::test
