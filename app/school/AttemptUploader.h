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
    std::uint64_t generation = 0;        ///< of the tooth that was graded; 0: none of the present ones
    std::filesystem::path journal = {};  ///< file of the attempt until it is in the outbox; empty: none
};

/// Graded attempts that are not in the outbox yet. If the disk refuses one, it is tried again every five seconds, also
/// when another user is logged in: there may be room. Ui thread.
class AttemptUploader final : public QObject
{
    Q_OBJECT

public:
    /// @param desk  outlives this
    explicit AttemptUploader(SchoolService& desk);

    /// Writes an attempt to the outbox. Emits kept(), or refused() each time the disk refuses it. An attempt that is
    /// here already is not added again.
    void send(const std::shared_ptr<const PendingAttempt>& letter);
    /// Sends the beginning of an exam, again and again as long as the disk refuses it.
    void send(const database::Login& who, const database::ExamStart& start);
    [[nodiscard]] int count() const { return static_cast<int>(m_waiting.size()); }
    [[nodiscard]] bool hasAnyOf(const database::Login& who) const;
    [[nodiscard]] std::set<std::filesystem::path> journals() const;

signals:
    /// Emitted when an attempt is in the outbox, or was refused.
    /// @param isAgain  the attempt had been refused before
    void kept(const app::PendingAttempt& letter, bool isAgain);
    void refused(const app::PendingAttempt& letter, bool isAgain, const core::Error& why);

private:
    void offer(const std::shared_ptr<const PendingAttempt>& letter, bool isAgain);

    SchoolService& m_desk;
    std::map<std::string, std::shared_ptr<const PendingAttempt>> m_waiting;  ///< by uid
};

}  // namespace app
