// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

namespace lab {

/// Power of a sound by frequency, from a Fourier transform with a Hann window.
class Spectrum
{
public:
    /// @param samples  at least two; those beyond the largest power of two are ignored
    Spectrum(std::span<const float> samples, double rateHz);

    /// Returns the frequency of the strongest line between two frequencies, Hz, to a fraction of a bin.
    [[nodiscard]] double strongestHz(double fromHz, double toHz) const;
    /// Returns the power between two frequencies; comparable only with spectra of the same length and rate.
    [[nodiscard]] double power(double fromHz, double toHz) const;
    /// Returns the mean frequency between two, weighted by power, Hz: the brightness of a noise.
    [[nodiscard]] double centroidHz(double fromHz, double toHz) const;

private:
    [[nodiscard]] std::size_t binOf(double hz) const;

    double m_binHz = 1.0;
    std::vector<double> m_power;
};

}  // namespace lab
