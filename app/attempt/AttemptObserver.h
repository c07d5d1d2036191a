// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>

#include <QObject>
#include <QString>
#include <QTimer>

#include "app/attempt/AttemptController.h"
#include "app/attempt/ResumeController.h"
#include "app/school/AttemptLimit.h"
#include "app/school/AttemptUploader.h"
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
    explicit AttemptObserver(const Parts& parts);

    /// Sets where the beginning of an exam is sent to; null: there is no database.
    void setUploader(AttemptUploader* uploader) { m_uploader = uploader; }

    /// Returns the hand that the student worked with for most of the attempt.
    [[nodiscard]] QString hand() const;
    /// Returns the kind of picture that the student saw for most of the attempt.
    [[nodiscard]] ui::render::Stereo picture() const;

private:
    void observe();
    void watchExam(const core::session::Findings& findings);

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
    AttemptUploader* m_uploader = nullptr;
    QTimer m_timer;
    std::map<ui::render::Stereo, int> m_cutIn;  ///< looks at the attempt that found it being cut, by kind of picture
    std::map<QString, int> m_cutWith;           ///< the same, by the hand that moves the bur
};

}  // namespace app
