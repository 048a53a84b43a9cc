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

BRACHIUM_INLINE Lane& At(double* x) { return *reinterpret_cast<Lane*>(x); }
BRACHIUM_INLINE const Lane& At(const double* x) { return *reinterpret_cast<const Lane*>(x); }

constexpr int LaneOf(int row) { return row / kLane * kLane; }

// Rows [begin, end) of two columns: c_0 += M w_0, c_1 += M w_1. M has kWidth columns; begin and end
// are multiples of kLane. kSet: = for +=.
template <int kWidth, bool kSet = false>
BRACHIUM_INLINE void AddToTwo(const double* M, int stride, const double* w_0, const double* w_1,
                              int begin, int end, double* c_0, double* c_1) {
  for (int row = begin; row < end; row += kLane) {
    Lane sum_0 = {}, sum_1 = {};
    if (!kSet) sum_0 = At(c_0 + row), sum_1 = At(c_1 + row);
    for (int m = 0; m < kWidth; ++m) {
      const Lane entry = At(M + m * stride + row);
      sum_0 += w_0[m] * entry;
      sum_1 += w_1[m] * entry;
    }
    At(c_0 + row) = sum_0;
    At(c_1 + row) = sum_1;
  }
}

template <int kWidth, bool kSet = false>
BRACHIUM_INLINE void AddToOne(const double* M, int stride, const double* w, int begin, int end,
                              double* c) {
  for (int row = begin; row < end; row += kLane) {
    Lane sum = {};
    if (!kSet) sum = At(c + row);
    for (int m = 0; m < kWidth; ++m) sum += w[m] * At(M + m * stride + row);
    At(c + row) = sum;
  }
}

// Columns [first, columns) of the lower triangle: C += sign M Wᵀ, where row j of W lies in M's row j.
template <int kWidth, bool kSet>
BRACHIUM_INLINE void AddSquare(double sign, const double* M, int stride, int first, int columns,
                               double* C) {
  double w_0[kWidth], w_1[kWidth];
  int j = first;
  for (; j + 1 < columns; j += 2) {
    for (int m = 0; m < kWidth; ++m) w_0[m] = sign * M[m * stride + j];
    for (int m = 0; m < kWidth; ++m) w_1[m] = sign * M[m * stride + j + 1];
    AddToTwo<kWidth, kSet>(M, stride, w_0, w_1, LaneOf(j), stride, C + j * stride,
                           C + (j + 1) * stride);
  }
  if (j == columns) return;
  for (int m = 0; m < kWidth; ++m) w_0[m] = sign * M[m * stride + j];
  AddToOne<kWidth, kSet>(M, stride, w_0, LaneOf(j), stride, C + j * stride);
}

template <bool kSet>
BRACHIUM_INLINE void AddSquare(int width, double sign, const double* M, int stride, int first,
                               int columns, double* C) {
  switch (width) {
    case 4:
      return AddSquare<4, kSet>(sign, M, stride, first, columns, C);
    case 3:
      return AddSquare<3, kSet>(sign, M, stride, first, columns, C);
    case 2:
      return AddSquare<2, kSet>(sign, M, stride, first, columns, C);
    default:
      return AddSquare<1, kSet>(sign, M, stride, first, columns, C);
  }
}

// Σ a_i b_i over [begin, end); end is a multiple of kLane.
BRACHIUM_INLINE double Dot(const double* a, const double* b, int begin, int end) {
  double sum = 0.0;
  for (; begin < end && begin % kLane != 0; ++begin) sum += a[begin] * b[begin];
  Lane even = {}, odd = {};
  for (; begin + kLane < end; begin += 2 * kLane) {
    even += At(a + begin) * At(b + begin);
    odd += At(a + begin + kLane) * At(b + begin + kLane);
  }
  if (begin < end) even += At(a + begin) * At(b + begin);
  even += odd;
  return sum + ((even[0] + even[1]) + (even[2] + even[3]));
}

// X ← X L⁻¹ in place: x_k = (x_k - Σ_m>k L(m, k) x_m) / L(k, k), last column first.
BRACHIUM_INLINE void DivideByFactor(const double* L, int stride, int pivots, double* X) {
  for (int k = pivots - 1; k >= 0; --k) {
    double* x = X + k * stride;
    const double* l = L + k * stride;
    for (int m = k + 1; m < pivots; ++m) {
      const double w = -l[m];
      AddToOne<1>(X + m * stride, stride, &w, 0, stride, x);
    }
    const double inverse = 1.0 / l[k];
    for (int row = 0; row < stride; row += kLane) At(x + row) *= inverse;
  }
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
void SquareColumns(const double* W, int rows, int columns, double* P) {
  const int stride = Padded(columns);
  const int first = rows == 6 ? 3 : std::min(4, rows);  // 6 are two times 3
  AddSquare<true>(first, 1.0, W, stride, 0, columns, P);
  for (int row = first; row < rows; row += 4)
    AddSquare<false>(std::min(4, rows - row), 1.0, W + row * stride, stride, 0, columns, P);
}

BRACHIUM_FOR_THIS_MACHINE
int FactorFront(double* H, int stride, int columns, int pivots, const double* least) {
  int raised = 0;
  for (int begin = 0; begin < pivots; begin += 4) {
    const int end = std::min(begin + 4, pivots);
    for (int k = begin; k < end; ++k) {
      double* column = H + k * stride;
      for (int m = begin; m < k; ++m) {
        const double w = -H[m * stride + k];
        AddToOne<1>(H + m * stride, stride, &w, LaneOf(k), stride, column);
      }
      if (!(column[k] > least[k])) {
        column[k] = kRaised * least[k];
        ++raised;
      }
      const double root = std::sqrt(column[k]), inverse = 1.0 / root;
      for (int row = LaneOf(k); row < stride; row += kLane) At(column + row) *= inverse;
      column[k] = root;
    }
    AddSquare<false>(end - begin, -1.0, H + begin * stride, stride, end, columns, H);
  }
  return raised;
}

BRACHIUM_FOR_THIS_MACHINE
void BackSubstitute(const double* L, int stride, int columns, int pivots, const double* y,
                    double* d) {
  for (int row = columns; row < stride; ++row) d[row] = 0.0;
  for (int k = pivots - 1; k >= 0; --k) {
    const double* column = L + k * stride;
    d[k] = -(Dot(column, d, k + 1, stride) + y[k]) / column[k];
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
    for (int m = 0; m <= k; ++m)
      column[m] = S[m * stride + k] = Dot(X + m * stride, Z + k * stride, 0, stride);
    for (int row = pivots; row < columns; ++row)
      column[row] = S[row * stride + k] = -Z[k * stride + row];
    std::fill(column + columns, column + stride, 0.0);
  }
}

}  // namespace brachium
