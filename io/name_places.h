// Names numbered in the order of their appearance.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace brachium {

class NamePlaces {
 public:
  std::size_t Of(const std::string& name) {
    const auto [found, is_new] = places_.emplace(name, names_.size());
    if (is_new) names_.push_back(name);
    return found->second;
  }
  const std::vector<std::string>& names() const { return names_; }

 private:
  std::map<std::string, std::size_t> places_;
  std::vector<std::string> names_;
};

}  // namespace brachium
