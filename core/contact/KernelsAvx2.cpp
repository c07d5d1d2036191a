// SPDX-License-Identifier: GPL-3.0-or-later
// Compiled with -mavx2 (and without FMA, which would change results). Empty where the processor family has no AVX2.
#ifdef CUSP_HAVE_AVX2
#include "core/contact/KernelsImpl.inc"

namespace core::contact {

extern const Kernels kAvx2Kernels;
const Kernels kAvx2Kernels{
    "avx2", mostInTheWay<Side::Above>, mostInTheWay<Side::Beneath>, roomAt, columnsUnder, secondsToRemove, remove};

}  // namespace core::contact
#endif
