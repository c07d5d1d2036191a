// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <map>

#include <QObject>
#include <QString>
#include <QTimer>

#include "app/attempt/AttemptController.h"
#include "app/attempt/ResumeController.h"
#include "app/school/AttemptLimit.h"
#include "app/school/SchoolSession.h"
#include "database/AttemptRecord.h"
#include "ui/render/Presenter.h"

namespace app {

/// Looks at the current attempt twenty times a second: shows how an exercise goes, explains a broken rule, records that
/// an exam has begun, and counts with which hand and in which kind of picture the student works. Ui thread.
class AttemptObserver final : public QObject
{
    Q_OBJECT

public:
    /// All of them outlive the observer.
    struct Parts
    {
        ui::window::MainWindow& window;
        core::session::UiChannels& channels;
        core::session::SessionLoop& session;
        core::session::LiveAssessmentLoop& assessment;
        DeviceController& devices;
        CurrentAttempt& attempt;
        AttemptController& attempts;
        ResumeController& resume;
        AttemptLimit& limit;
        const SchoolSession& school;
    };
    /// @param retry  the time after which a refused record of an exam is written again
    AttemptObserver(const Parts& parts, std::chrono::milliseconds retry);

    /// Returns the hand that the student worked with for most of the attempt.
    [[nodiscard]] QString hand() const;
    /// Returns the kind of picture that the student saw for most of the attempt.
    [[nodiscard]] ui::render::Stereo picture() const;

private:
    void observe();
    void watchExam(const core::session::Findings& findings);
    void recordExam(const database::Login& who, const database::ExamStart& start);

    ui::window::MainWindow& m_window;
    core::session::UiChannels& m_channels;
    core::session::SessionLoop& m_session;
    core::session::LiveAssessmentLoop& m_assessment;
    DeviceController& m_devices;
    CurrentAttempt& m_attempt;
    AttemptController& m_attempts;
    ResumeController& m_resume;
    AttemptLimit& m_limit;
    const SchoolSession& m_school;
    std::chrono::milliseconds m_retry;
    QTimer m_timer;
    std::map<ui::render::Stereo, int> m_cutIn;  ///< looks at the attempt that found it being cut, by kind of picture
    std::map<QString, int> m_cutWith;           ///< the same, by the hand that moves the bur
};

}  // namespace app
