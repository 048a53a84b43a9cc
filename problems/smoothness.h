// How smooth a movement was, from its speed, evenly sampled from start to end.
#pragma once

#include <vector>

namespace brachium {

// Spectral arc length: minus the length of the curve of the amplitude spectrum, over its greatest
// value, over the frequency divided by the greatest one kept, up to 10 Hz and there to the last
// amplitude of 0.05; the series is padded to 2^4 times the next power of two
// (to 2^17 samples if that is less: what lasts longer is not one movement). Closer to zero is smoother.
// NaN below two samples, without movement, and with a NaN.
// Source: Balasubramanian, Melendez-Calderon & Burdet, IEEE T-BME 59 (2012); J. NeuroEng. Rehabil. 12
// (2015).
double SpectralArcLength(const std::vector<double>& speed, double rate_hz);

// -ln(T³/v_peak² ∫|v''|² dt), v'' by second forward differences, T = n/rate. Closer to zero is
// smoother; independent of duration and amplitude, but not of noise. NaN below three samples and
// without movement. Source: Balasubramanian et al. (2015), from Hogan & Sternad, J. Mot. Behav. 41
// (2009).
double LogDimensionlessJerk(const std::vector<double>& speed, double rate_hz);

// How many maxima stand out by at least that share of the greatest value: the drop on either side to
// a higher value or to the end. A movement of one submovement has 1.
int SpeedPeaks(const std::vector<double>& speed, double least_prominence = 0.05);

}  // namespace brachium
