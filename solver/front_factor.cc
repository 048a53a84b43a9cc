#include "solver/front_factor.h"

#include <algorithm>
#include <cmath>

#if defined(__x86_64__) && defined(__linux__) && __GNUC__ >= 12 && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define BRACHIUM_FOR_THIS_MACHINE __attribute__((target_clones("arch=x86-64-v3", "default")))
#else
#define BRACHIUM_FOR_THIS_MACHINE
#endif
#define BRACHIUM_INLINE inline __attribute__((always_inline))

namespace brachium {
namespace {

// Four numbers as one, at any address.
typedef double Lane __attribute__((vector_size(kLane * sizeof(double)), aligned(8), may_alias));

typedef Kept KeptLane __attribute__((vector_size(kLane * sizeof(Kept)), aligned(4), may_alias));

BRACHIUM_INLINE Lane& At(double* x) { return *reinterpret_cast<Lane*>(x); }
BRACHIUM_INLINE const Lane& At(const double* x) { return *reinterpret_cast<const Lane*>(x); }

constexpr int LaneOf(int row) { return row / kLane * kLane; }

// Rows [begin, end) of two columns: c_0 += M w_0, c_1 += M w_1. M has kWidth columns; begin and end
// are multiples of kLane.
template <int kWidth>
BRACHIUM_INLINE void AddToTwo(const double* M, int stride, const double* w_0, const double* w_1,
                              int begin, int end, double* c_0, double* c_1) {
  for (int row = begin; row < end; row += kLane) {
    Lane sum_0 = At(c_0 + row), sum_1 = At(c_1 + row);
    for (int m = 0; m < kWidth; ++m) {
      const Lane entry = At(M + m * stride + row);
      sum_0 += w_0[m] * entry;
      sum_1 += w_1[m] * entry;
    }
    At(c_0 + row) = sum_0;
    At(c_1 + row) = sum_1;
  }
}

template <int kWidth>
BRACHIUM_INLINE void AddToOne(const double* M, int stride, const double* w, int begin, int end,
                              double* c) {
  for (int row = begin; row < end; row += kLane) {
    Lane sum = At(c + row);
    for (int m = 0; m < kWidth; ++m) sum += w[m] * At(M + m * stride + row);
    At(c + row) = sum;
  }
}

// Columns [first, end) of the lower triangle: C -= M Mᵀ, M with kWidth columns.
template <int kWidth>
BRACHIUM_INLINE void SubtractSquare(const double* M, int stride, int first, int end, double* C) {
  double w_0[kWidth], w_1[kWidth];
  int j = first;
  for (; j + 1 < end; j += 2) {
    for (int m = 0; m < kWidth; ++m) w_0[m] = -M[m * stride + j];
    for (int m = 0; m < kWidth; ++m) w_1[m] = -M[m * stride + j + 1];
    AddToTwo<kWidth>(M, stride, w_0, w_1, LaneOf(j), stride, C + j * stride, C + (j + 1) * stride);
  }
  if (j == end) return;
  for (int m = 0; m < kWidth; ++m) w_0[m] = -M[m * stride + j];
  AddToOne<kWidth>(M, stride, w_0, LaneOf(j), stride, C + j * stride);
}

BRACHIUM_INLINE void SubtractSquare(int width, const double* M, int stride, int first, int end,
                                    double* C) {
  switch (width) {
    case 4:
      return SubtractSquare<4>(M, stride, first, end, C);
    case 3:
      return SubtractSquare<3>(M, stride, first, end, C);
    case 2:
      return SubtractSquare<2>(M, stride, first, end, C);
    default:
      return SubtractSquare<1>(M, stride, first, end, C);
  }
}

// Adds Aᵀ B of kBlocks neighbouring blocks B at `to[b]`, with A's kColumns columns `stride` apart.
template <int kColumns, int kBlocks>
BRACHIUM_INLINE void AddProducts(const double* A, const double* B, int rows, int stride,
                                 double* const* to) {
  Lane sums[kBlocks][kColumns] = {};
  for (int m = 0; m < rows; ++m)
    for (int b = 0; b < kBlocks; ++b) {
      const Lane row = At(B + (b * rows + m) * kLane);
      for (int c = 0; c < kColumns; ++c) sums[b][c] += A[m * kLane + c] * row;
    }
  for (int b = 0; b < kBlocks; ++b)
    for (int c = 0; c < kColumns; ++c) At(to[b] + c * stride) += sums[b][c];
}

// A block's products with itself and with all that follow it, of which there are `count` with it.
template <int kColumns>
BRACHIUM_INLINE void AddRow(const double* W, int rows, int count, const FrontBlock* blocks,
                            int gradient_row, int stride) {
  double* const column = blocks[0].column;
  int i = 0;
  for (; i + 1 < count; i += 2) {
    double* const to[] = {column + blocks[i].row, column + blocks[i + 1].row};
    AddProducts<kColumns, 2>(W, W + i * rows * kLane, rows, stride, to);
  }
  double* const to[] = {column + blocks[i < count ? i : 0].row, column + gradient_row};
  if (i < count)
    AddProducts<kColumns, 2>(W, W + i * rows * kLane, rows, stride, to);
  else
    AddProducts<kColumns, 1>(W, W + i * rows * kLane, rows, stride, to + 1);
}

BRACHIUM_INLINE double Sum(Lane lane) { return (lane[0] + lane[1]) + (lane[2] + lane[3]); }

// d_k = -(y_k + Σ_m>k L(m, k) d_m) / L(k, k) for kColumns columns from `begin` on, last column first.
template <int kColumns, int kSides>
BRACHIUM_INLINE void BackSubstituteColumns(const Kept* L, int stride, int begin,
                                           const double* const* y, double* const* d) {
  const Kept* columns = L + begin * stride;
  const int end = begin + kColumns;
  Lane sums[kSides][kColumns] = {};
  int row = end;
  for (; row % kLane != 0 && row < stride; ++row)
    for (int s = 0; s < kSides; ++s)
      for (int c = 0; c < kColumns; ++c) sums[s][c][0] += columns[c * stride + row] * d[s][row];
  for (; row < stride; row += kLane)
    for (int c = 0; c < kColumns; ++c) {
      const auto& kept = *reinterpret_cast<const KeptLane*>(columns + c * stride + row);
      const Lane entry = __builtin_convertvector(kept, Lane);
      for (int s = 0; s < kSides; ++s) sums[s][c] += entry * At(d[s] + row);
    }
  for (int s = 0; s < kSides; ++s)
    for (int c = kColumns - 1; c >= 0; --c) {
      const Kept* column = columns + c * stride;
      double sum = y[s][begin + c] + Sum(sums[s][c]);
      for (int m = begin + c + 1; m < end; ++m) sum += column[m] * d[s][m];
      d[s][begin + c] = -sum / column[begin + c];
    }
}

template <int kSides>
BRACHIUM_INLINE void BackSubstituteSome(const Kept* L, int stride, int begin, int pivots,
                                        const double* const* y, double* const* d) {
  switch (pivots - begin) {
    case 1:
      return BackSubstituteColumns<1, kSides>(L, stride, begin, y, d);
    case 2:
      return BackSubstituteColumns<2, kSides>(L, stride, begin, y, d);
    case 3:
      return BackSubstituteColumns<3, kSides>(L, stride, begin, y, d);
    default:
      return BackSubstituteColumns<4, kSides>(L, stride, begin, y, d);
  }
}

// X ← X L⁻¹ in place: x_k = (x_k - Σ_m>k L(m, k) x_m) / L(k, k), last column first.
BRACHIUM_INLINE void DivideByFactor(const double* L, int stride, int pivots, double* X) {
  for (int k = pivots - 1; k >= 0; --k) {
    double* x = X + k * stride;
    const double* l = L + k * stride;
    int m = k + 1;
    for (; m + 4 <= pivots; m += 4) {
      const double w[] = {-l[m], -l[m + 1], -l[m + 2], -l[m + 3]};
      AddToOne<4>(X + m * stride, stride, w, 0, stride, x);
    }
    for (; m < pivots; ++m) {
      const double w = -l[m];
      AddToOne<1>(X + m * stride, stride, &w, 0, stride, x);
    }
    const double inverse = 1.0 / l[k];
    for (int row = 0; row < stride; row += kLane) At(x + row) *= inverse;
  }
}

// Of kColumns columns of X, the products with z.
template <int kColumns>
BRACHIUM_INLINE void Dots(const double* X, int stride, const double* z, double* dots) {
  Lane sums[kColumns] = {};
  for (int row = 0; row < stride; row += kLane) {
    const Lane entry = At(z + row);
    for (int c = 0; c < kColumns; ++c) sums[c] += At(X + c * stride + row) * entry;
  }
  for (int c = 0; c < kColumns; ++c) dots[c] = Sum(sums[c]);
}

// Columns [j, j + kWidth) of M times the same rows of X, added to the rows [begin, stride) of Z.
template <int kWidth>
BRACHIUM_INLINE void AddProduct(const double* M, const double* X, int stride, int pivots, int begin,
                                double* Z) {
  int k = 0;
  for (; k + 1 < pivots; k += 2)
    AddToTwo<kWidth>(M, stride, X + k * stride, X + (k + 1) * stride, begin, stride, Z + k * stride,
                     Z + (k + 1) * stride);
  if (k < pivots) AddToOne<kWidth>(M, stride, X + k * stride, begin, stride, Z + k * stride);
}

}  // namespace

BRACHIUM_FOR_THIS_MACHINE
void AddSquare(const double* W, int rows, std::span<const FrontBlock> blocks, int gradient_row,
               int stride, double* squares, double* gradient) {
  const int count = static_cast<int>(blocks.size()), size = rows * kLane;
  const double* r = W + count * size;
  for (int b = 0; b < count; ++b, W += size) {
    Lane square = {}, slope = {};
    for (int m = 0; m < size; m += kLane) {
      square += At(W + m) * At(W + m);
      slope += r[m] * At(W + m);
    }
    At(squares + b * kLane) = square;
    At(gradient + b * kLane) = slope;
    const FrontBlock* block = blocks.data() + b;
    if (block->columns == 3)
      AddRow<3>(W, rows, count - b, block, gradient_row, stride);
    else if (block->columns == 2)
      AddRow<2>(W, rows, count - b, block, gradient_row, stride);
    else
      AddRow<1>(W, rows, count - b, block, gradient_row, stride);
  }
}

BRACHIUM_FOR_THIS_MACHINE
int FactorFront(double* E, double* S, int stride, int columns, int pivots, const double* least) {
  int raised = 0;
  for (int begin = 0; begin < pivots; begin += 4) {
    const int end = std::min(begin + 4, pivots);
    for (int k = begin; k < end; ++k) {
      double* column = E + k * stride;
      for (int m = begin; m < k; ++m) {
        const double w = -E[m * stride + k];
        AddToOne<1>(E + m * stride, stride, &w, LaneOf(k), stride, column);
      }
      if (!(column[k] > least[k])) {
        column[k] = kRaised * least[k];
        ++raised;
      }
      const double root = std::sqrt(column[k]), inverse = 1.0 / root;
      for (int row = LaneOf(k); row < stride; row += kLane) At(column + row) *= inverse;
      column[k] = root;
    }
    SubtractSquare(end - begin, E + begin * stride, stride, end, pivots, E);
    SubtractSquare(end - begin, E + begin * stride, stride, pivots, columns, S);
  }
  return raised;
}

BRACHIUM_FOR_THIS_MACHINE
void Keep(const double* E, int numbers, Kept* kept) {
  for (int i = 0; i < numbers; i += kLane)
    *reinterpret_cast<KeptLane*>(kept + i) = __builtin_convertvector(At(E + i), KeptLane);
}

BRACHIUM_FOR_THIS_MACHINE
void BackSubstitute(const Kept* L, int stride, int columns, int pivots, int sides,
                    const double* const* y, double* const* d) {
  for (int side = 0; side < sides; ++side)
    for (int row = columns; row < stride; ++row) d[side][row] = 0.0;
  for (int begin = Padded(pivots) - kLane; begin >= 0; begin -= kLane) {
    int side = 0;
    for (; side + 3 <= sides; side += 3)
      BackSubstituteSome<3>(L, stride, begin, pivots, y + side, d + side);
    for (; side < sides; ++side)
      BackSubstituteSome<1>(L, stride, begin, pivots, y + side, d + side);
  }
}

BRACHIUM_FOR_THIS_MACHINE
void ExtendCovariance(const double* L, int stride, int columns, int pivots, double* S,
                      double* scratch) {
  // X = [I; B] L⁻¹ = [L⁻¹; Aᵀ] and Z = [L⁻¹; Σ_SS Aᵀ]: then Σ_EE = Xᵀ Z.
  double* X = scratch;
  double* Z = scratch + pivots * stride;
  std::fill_n(scratch, 2 * pivots * stride, 0.0);
  for (int k = 0; k < pivots; ++k) {
    X[k * stride + k] = 1.0;
    std::copy(L + k * stride + pivots, L + k * stride + columns, X + k * stride + pivots);
  }
  DivideByFactor(L, stride, pivots, X);
  int j = pivots;
  for (; j + 4 <= columns; j += 4)
    AddProduct<4>(S + j * stride, X + j, stride, pivots, LaneOf(pivots), Z);
  for (; j < columns; ++j) AddProduct<1>(S + j * stride, X + j, stride, pivots, LaneOf(pivots), Z);
  for (int k = 0; k < pivots; ++k) std::copy_n(X + k * stride, pivots, Z + k * stride);
  for (int k = 0; k < pivots; ++k) {
    double* column = S + k * stride;
    const double* z = Z + k * stride;
    int m = 0;
    for (; m + 4 <= k + 1; m += 4) Dots<4>(X + m * stride, stride, z, column + m);
    for (; m <= k; ++m) Dots<1>(X + m * stride, stride, z, column + m);
    for (m = 0; m < k; ++m) S[m * stride + k] = column[m];
    for (int row = pivots; row < columns; ++row)
      column[row] = S[row * stride + k] = -Z[k * stride + row];
    std::fill(column + columns, column + stride, 0.0);
  }
}

}  // namespace brachium
