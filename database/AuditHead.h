// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace database {

/// Number and hash of the newest row of the audit; 0 and empty if the audit is empty.
struct AuditHead
{
    std::int64_t seq = 0;
    std::string hash;
    bool operator==(const AuditHead&) const = default;

    /// Returns the audit code as reports show it: "412-9f3ac07be1d2". `cusp db check --witness` accepts it.
    [[nodiscard]] std::string code() const;
};

/// Parses an audit code: returns the number of the row and the typed digits of its hash (12 to 64), in lower case.
/// Empty if the text is no audit code.
[[nodiscard]] std::optional<AuditHead> readAuditCode(const std::string& typed);

/// Selects the rows of the audit to read. In a busy school, most rows record that an attempt was begun or saved.
enum class AuditRows { All, WithoutAttempts };

}  // namespace database
