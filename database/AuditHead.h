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

    /// The audit code, as reports show it: "412-9f3ac07be1d2". `cusp db check --witness` takes it.
    [[nodiscard]] std::string code() const;
};

/// Returns the row that an audit code names, and as many digits of its hash as were typed (12 to 64), in small letters.
/// Empty: the text is not an audit code.
[[nodiscard]] std::optional<AuditHead> readAuditCode(const std::string& typed);

/// Which rows of the audit are read: in a busy school most rows record that an attempt was begun or saved.
enum class AuditRows { All, WithoutAttempts };

}  // namespace database
