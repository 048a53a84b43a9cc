// The arithmetic of the block elimination: small dense loops over 4 numbers at a time.
//
// A front is column-major with `stride` numbers a column, a multiple of kLane; of its symmetric
// matrix the lower triangle counts, and what stands above it is overwritten at will. On x86-64 Linux
// the loops exist twice, the machine chooses when the program starts: last digits then depend on it.
#pragma once

#include <span>

namespace brachium {

constexpr int kLane = 4;  // numbers that the loops take at a time

// What is kept of a factor. In single precision it takes half the memory, most of what a trial needs;
// a step then has seven digits, enough to descend by a gradient that has all.
using Kept = float;

constexpr int Padded(int rows) { return (rows + kLane - 1) / kLane * kLane; }

// One block of a term's Jacobian, and where it belongs in a front.
struct FrontBlock {
  int columns;     // 1 to 3
  int row;         // of the front: its first column's number
  double* column;  // of the front
};

// Adds [J r]ᵀ [J r] of a term to the lower triangle of a front with its gradient row.
// W: J's blocks, from first to last row of the front, and then r: each `rows` rows of kLane numbers,
// zero past its columns. `blocks`: those of J. `squares`, `gradient`: kLane numbers a block of J, set
// to the sums of W's squares and of W r. A front's last column is followed by kLane numbers of room.
void AddSquare(const double* W, int rows, std::span<const FrontBlock> blocks, int gradient_row,
               int stride, double* squares, double* gradient);

// Partial Cholesky factorisation of a front of `columns` columns whose row `columns` holds the
// gradient g, followed by zeros. The columns to eliminate, E, are the first `pivots`; the others stand
// from S + pivots * stride on. Of [H_EE; H_SE; g_Eᵀ] it leaves [L; B; yᵀ] with L Lᵀ = H_EE,
// B = H_SE L⁻ᵀ, y = L⁻¹ g_E, and of the rest [H_SS - B Bᵀ; g_Sᵀ - yᵀ Bᵀ].
// A pivot that does not exceed its entry in `least` is put to kRaised times that entry.
// Returns the number of pivots raised.
constexpr double kRaised = 1e4;
int FactorFront(double* E, double* S, int stride, int columns, int pivots, const double* least);

// Rounds `numbers`, a multiple of kLane, to what is kept.
void Keep(const double* E, int numbers, Kept* kept);

// The steps of the eliminated unknowns from those of the others: d_E = -L⁻ᵀ (y + Bᵀ d_S). `L`: what
// is kept of the first `pivots` columns that FactorFront left. Of each of `sides`, y: `pivots`
// numbers, d: `stride` numbers, of which d_S is given; what follows d is overwritten.
void BackSubstitute(const Kept* L, int stride, int columns, int pivots, int sides,
                    const double* const* y, double* const* d);

// Extends a covariance from S to E. Given is Σ_SS in the symmetric matrix `S`, whole columns of
// `stride` numbers with their padding zero; with A = L⁻ᵀ Bᵀ there are added Σ_SE = -Σ_SS Aᵀ, its
// transpose, and Σ_EE = L⁻ᵀ L⁻¹ + A Σ_SS Aᵀ. `scratch`: 2 * pivots * stride numbers.
void ExtendCovariance(const double* L, int stride, int columns, int pivots, double* S,
                      double* scratch);

}  // namespace brachium
