// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <string>

#include <QObject>

#include "app/school/SchoolService.h"
#include "core/recording/Recording.h"
#include "database/AttemptRecord.h"
#include "database/Person.h"

namespace app {

/// A graded attempt on its way to the outbox.
struct PendingAttempt
{
    database::Login who;
    database::AttemptRecord record;
    core::recording::Recording recording;
    std::uint64_t generation = 0;        ///< of the tooth that was graded; 0: not shown since the program started
    std::filesystem::path journal = {};  ///< file that stores the attempt until it is in the outbox; empty: none
};

/// Writes graded attempts to the outbox. If an attempt cannot be written, because the disk is full for example, tries
/// again every five seconds, also when another user is logged in. Ui thread.
class AttemptUploader final : public QObject
{
    Q_OBJECT

public:
    /// @param desk  must outlive this object
    explicit AttemptUploader(SchoolService& desk);

    /// Writes an attempt to the outbox. Emits kept() when the attempt is written, and refused() each time it cannot be
    /// written. Does nothing if the attempt is still waiting from an earlier call.
    void send(const std::shared_ptr<const PendingAttempt>& letter);
    /// Writes the start of an exam to the outbox. Repeats this until it succeeds.
    void send(const database::Login& who, const database::ExamStart& start);
    /// Returns the number of attempts that are not in the outbox yet.
    [[nodiscard]] int count() const { return static_cast<int>(m_waiting.size()); }
    [[nodiscard]] bool hasAnyOf(const database::Login& who) const;
    [[nodiscard]] std::set<std::filesystem::path> journals() const;

signals:
    /// Emitted when an attempt has been written to the outbox.
    /// @param isAgain  whether an earlier try failed
    void kept(const app::PendingAttempt& letter, bool isAgain);
    /// Emitted when an attempt could not be written. The next try follows in five seconds.
    void refused(const app::PendingAttempt& letter, bool isAgain, const core::Error& why);

private:
    void offer(const std::shared_ptr<const PendingAttempt>& letter, bool isAgain);

    SchoolService& m_desk;
    std::map<std::string, std::shared_ptr<const PendingAttempt>> m_waiting;  ///< by uid
};

}  // namespace app
