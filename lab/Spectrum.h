// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

namespace lab {

/// Power of a sound by frequency, from a Fourier transform with a Hann window.
class Spectrum
{
public:
    /// @param samples  at least two; those beyond the greatest power of two are left out
    Spectrum(std::span<const float> samples, double rateHz);

    /// Frequency of the strongest line between two frequencies, Hz, to a fraction of a bin.
    [[nodiscard]] double strongestHz(double fromHz, double toHz) const;
    /// Power between two frequencies; comparable with spectra of the same length and rate only.
    [[nodiscard]] double power(double fromHz, double toHz) const;
    /// Mean frequency between two, weighted with the power, Hz: how bright a noise is.
    [[nodiscard]] double centroidHz(double fromHz, double toHz) const;

private:
    [[nodiscard]] std::size_t binOf(double hz) const;

    double m_binHz = 1.0;
    std::vector<double> m_power;
};

}  // namespace lab
