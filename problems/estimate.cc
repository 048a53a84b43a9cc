#include "problems/estimate.h"

namespace brachium {
namespace {

template <typename Series>
void Append(const Series& piece, Series& whole) {
  whole.insert(whole.end(), piece.begin(), piece.end());
}

template <typename Key, typename Series>
void AppendAll(const std::map<Key, Series>& piece, std::map<Key, Series>& whole) {
  for (const auto& [key, series] : piece) Append(series, whole[key]);
}

}  // namespace

void AppendMotion(const Estimate& piece, Estimate& whole) {
  Append(piece.time, whole.time);
  AppendAll(piece.q_WB, whole.q_WB);
  AppendAll(piece.sd_B, whole.sd_B);
  AppendAll(piece.p_W, whole.p_W);
  AppendAll(piece.sd_W, whole.sd_W);
  AppendAll(piece.sd_angle, whole.sd_angle);
}

}  // namespace brachium
