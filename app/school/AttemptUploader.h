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
    std::filesystem::path journal = {};  ///< where the attempt lies until it is kept; empty: nowhere
};

/// Graded attempts that are not in the outbox yet. What the disk refuses is offered to it again every few seconds,
/// whoever works here by then: there may be room. Ui thread.
class AttemptUploader final : public QObject
{
    Q_OBJECT

public:
    /// @param desk  outlives this
    explicit AttemptUploader(SchoolService& desk);

    /// kept() follows, or refused(), and again as long as the disk refuses it. One that is here already goes as it is.
    void send(const std::shared_ptr<const PendingAttempt>& letter);
    /// Sends the beginning of an exam, again and again as long as the disk refuses it.
    void send(const database::Login& who, const database::ExamStart& start);
    [[nodiscard]] int count() const { return static_cast<int>(m_waiting.size()); }
    [[nodiscard]] bool hasAnyOf(const database::Login& who) const;
    [[nodiscard]] std::set<std::filesystem::path> journals() const;

signals:
    /// @param isAgain  it had been refused before
    void kept(const app::PendingAttempt& letter, bool isAgain);
    void refused(const app::PendingAttempt& letter, bool isAgain, const core::Error& why);

private:
    void offer(const std::shared_ptr<const PendingAttempt>& letter, bool isAgain);

    SchoolService& m_desk;
    std::map<std::string, std::shared_ptr<const PendingAttempt>> m_waiting;  ///< by uid
};

}  // namespace app
