// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/Spectrum.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <numbers>

namespace lab {
namespace {

using Complex = std::complex<double>;

/// Cooley and Tukey, 1965: transforms a power of two of values in place.
void transform(std::vector<Complex>& values)
{
    const std::size_t count = values.size();
    for (std::size_t k = 1, reversed = 0; k < count; ++k) {
        std::size_t bit = count >> 1U;
        for (; (reversed & bit) != 0; bit >>= 1U)
            reversed ^= bit;
        reversed ^= bit;
        if (k < reversed)
            std::swap(values[k], values[reversed]);
    }
    for (std::size_t half = 1; half < count; half *= 2) {
        const Complex turn = std::polar(1.0, -std::numbers::pi / static_cast<double>(half));
        for (std::size_t first = 0; first < count; first += 2 * half) {
            Complex factor = 1.0;
            for (std::size_t k = first; k < first + half; ++k) {
                const Complex other = factor * values[k + half];
                values[k + half] = values[k] - other;
                values[k] += other;
                factor *= turn;
            }
        }
    }
}

}  // namespace

Spectrum::Spectrum(std::span<const float> samples, double rateHz)
{
    const std::size_t count = std::bit_floor(samples.size());
    std::vector<Complex> values(count);
    for (std::size_t k = 0; k < count; ++k) {
        const double turn = 2.0 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(count);
        values[k] = static_cast<double>(samples[k]) * (0.5 - 0.5 * std::cos(turn));
    }
    transform(values);
    m_binHz = rateHz / static_cast<double>(count);
    m_power.resize(count / 2);
    for (std::size_t k = 0; k < m_power.size(); ++k)
        m_power[k] = std::norm(values[k]);
}

std::size_t Spectrum::binOf(double hz) const
{
    return std::min(static_cast<std::size_t>(std::max(0.0, hz / m_binHz)), m_power.size() - 1);
}

double Spectrum::strongestHz(double fromHz, double toHz) const
{
    const std::size_t from = binOf(fromHz);
    const auto* const first = m_power.data() + from;
    const auto* const last = m_power.data() + binOf(toHz) + 1;
    const std::size_t top = from + static_cast<std::size_t>(std::max_element(first, last) - first);
    // Between the bins: the mean of the three around the top.
    double sum = 0.0;
    double weighted = 0.0;
    for (std::size_t k = top == 0 ? 0 : top - 1; k <= std::min(top + 1, m_power.size() - 1); ++k) {
        sum += m_power[k];
        weighted += m_power[k] * static_cast<double>(k);
    }
    return sum > 0.0 ? weighted / sum * m_binHz : 0.0;
}

double Spectrum::power(double fromHz, double toHz) const
{
    double sum = 0.0;
    for (std::size_t k = binOf(fromHz); k <= binOf(toHz); ++k)
        sum += m_power[k];
    return sum;
}

double Spectrum::centroidHz(double fromHz, double toHz) const
{
    double sum = 0.0;
    double weighted = 0.0;
    for (std::size_t k = binOf(fromHz); k <= binOf(toHz); ++k) {
        sum += m_power[k];
        weighted += m_power[k] * static_cast<double>(k) * m_binHz;
    }
    return sum > 0.0 ? weighted / sum : 0.0;
}

}  // namespace lab
