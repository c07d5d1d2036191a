// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/KernelsImpl.inc"

#include <cstdlib>

namespace core::contact {

const Kernels kPlainKernels{
    "plain", mostInTheWay<Side::Above>, mostInTheWay<Side::Beneath>, roomAt, columnsUnder, secondsToRemove, remove};

#ifdef CUSP_HAVE_AVX2
extern const Kernels kAvx2Kernels;
#endif

const Kernels& kernels()
{
    static const Kernels& chosen = []() -> const Kernels& {
#ifdef CUSP_HAVE_AVX2
        if (std::getenv("CUSP_PLAIN_KERNELS") == nullptr && __builtin_cpu_supports("avx2") != 0)
            return kAvx2Kernels;
#endif
        return kPlainKernels;
    }();
    return chosen;
}

}  // namespace core::contact
