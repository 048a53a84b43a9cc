// Xsens MVN's XML.
#include <algorithm>
#include <charconv>
#include <pugixml.hpp>

#include "io/formats/motion_table.h"
#include "io/input_error.h"

namespace brachium {
namespace {

std::size_t LineAt(std::string_view text, std::ptrdiff_t offset) {
  const auto end = text.begin() + std::clamp<std::ptrdiff_t>(offset, 0, std::ssize(text));
  return 1 + static_cast<std::size_t>(std::count(text.begin(), end, '\n'));
}

class Reader {
 public:
  Reader(std::string_view text, const std::string& file) : text_(text), file_(file) {
    table_.file = file;
    table_.first_line = 1;
    table_.names.push_back("time_s");
    table_.columns.emplace_back();
  }

  CsvTable Read() {
    const auto parsed = document_.load_buffer(text_.data(), text_.size());
    if (!parsed)
      throw InputError(file_, LineAt(text_, parsed.offset),
                       std::string("is not sound XML: ") + parsed.description());
    const pugi::xml_node subject = document_.child("mvnx").child("subject");
    if (!subject) throw InputError(file_, 0, "has no mvnx/subject; expected an MVNX file");
    const std::vector<std::string> segments = Labels(subject.child("segments"), "segment");
    if (segments.empty()) throw InputError(file_, 0, "has no segments; expected an MVNX file");
    const std::vector<std::string> joints = Labels(subject.child("joints"), "joint");
    const Block blocks[] = {{"orientation", segments, {"_qw", "_qx", "_qy", "_qz"}},
                            {"position", segments, {"_px", "_py", "_pz"}},
                            {"jointAngle", joints, {"_zxy_x", "_zxy_y", "_zxy_z"}}};
    for (const pugi::xml_node frame : subject.child("frames").children("frame"))
      if (std::string_view(frame.attribute("type").value()) == "normal") frames_.push_back(frame);
    if (frames_.empty()) throw InputError(file_, 0, "has no frame of the type normal");
    for (const Block& block : blocks) ReadBlock(block);
    const double rate = Number(subject, subject.attribute("frameRate").value());
    if (!(rate >= 1.0 && rate <= 1e5))
      throw InputError(file_, LineAt(text_, subject.offset_debug()),
                       "has an impossible frameRate; expected frames a second");
    for (const pugi::xml_node frame : frames_)
      table_.columns[0].push_back(Number(frame, frame.attribute("index").value()) / rate);
    table_.rows = frames_.size();
    return std::move(table_);
  }

 private:
  struct Block {
    const char* name;
    const std::vector<std::string>& labels;
    std::vector<std::string> endings;
  };

  static std::vector<std::string> Labels(const pugi::xml_node& list, const char* kind) {
    std::vector<std::string> labels;
    for (const pugi::xml_node item : list.children(kind))
      labels.emplace_back(item.attribute("label").value());
    return labels;
  }

  double Number(const pugi::xml_node& at, std::string_view word) const {
    double value = 0.0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error == std::errc() && end == word.data() + word.size() && !word.empty()) return value;
    throw InputError(file_, LineAt(text_, at.offset_debug()),
                     "has '" + std::string(word.substr(0, 40)) + "' where a number was expected");
  }

  std::vector<double> Numbers(const pugi::xml_node& node) const {
    constexpr std::string_view kBlank = " \t\r\n";
    std::vector<double> numbers;
    const std::string_view words = node.text().get();
    for (auto begin = words.find_first_not_of(kBlank); begin != words.npos;) {
      const auto end = std::min(words.find_first_of(kBlank, begin), words.size());
      numbers.push_back(Number(node, words.substr(begin, end - begin)));
      begin = words.find_first_not_of(kBlank, end);
    }
    return numbers;
  }

  // A block that the first frame lacks is lacking everywhere.
  void ReadBlock(const Block& block) {
    if (!frames_.front().child(block.name)) return;
    const std::size_t first = table_.columns.size();
    for (const std::string& label : block.labels)
      for (const std::string& ending : block.endings) table_.names.push_back(label + ending);
    table_.columns.resize(table_.names.size());
    for (const pugi::xml_node& frame : frames_) {
      const pugi::xml_node node = frame.child(block.name);
      const std::vector<double> numbers = Numbers(node);
      if (numbers.size() != table_.columns.size() - first)
        throw InputError(file_, LineAt(text_, (node ? node : frame).offset_debug()),
                         std::string(block.name) + " has " + std::to_string(numbers.size()) +
                             " numbers; expected " + std::to_string(table_.columns.size() - first));
      for (std::size_t i = 0; i < numbers.size(); ++i)
        table_.columns[first + i].push_back(numbers[i]);
    }
  }

  const std::string_view text_;
  const std::string file_;
  pugi::xml_document document_;
  std::vector<pugi::xml_node> frames_;
  CsvTable table_;
};

}  // namespace

CsvTable ParseMvnx(std::string_view text, const std::string& file) {
  return Reader(text, file).Read();
}

}  // namespace brachium
