// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/ContactMethod.h"

#include <string>

#include "core/contact/ContinuousContact.h"
#include "core/contact/LatticeContact.h"
#include "core/contact/PenaltyContact.h"

namespace core::contact {

Result<std::unique_ptr<ContactMethod>> makeContactMethod(std::string_view name)
{
    if (name == "continuous")
        return std::make_unique<ContinuousContact>();
    if (name == "lattice")
        return std::make_unique<LatticeContact>();
    if (name == "lattice16")
        return std::make_unique<LatticeContact>(16);
    if (name == "penalty")
        return std::make_unique<PenaltyContact>();
    return unexpected(ErrorCode::UnknownName, "There is no contact method '" + std::string(name) +
                                                  "'; choose one of continuous, lattice, lattice16, penalty.");
}

}  // namespace core::contact
