// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>

#include <QObject>
#include <QString>
#include <QTimer>

#include "app/attempt/AttemptContext.h"
#include "app/attempt/AttemptController.h"
#include "app/attempt/ResumeController.h"
#include "app/school/AttemptUploader.h"
#include "database/AttemptRecord.h"
#include "ui/render/Presenter.h"

namespace app {

/// Looks at the current attempt twenty times a second: shows how an exercise goes, explains a broken rule, records that
/// an exam has begun, and counts with which hand and in which kind of picture the student works. Ui thread.
class AttemptObserver final : public QObject
{
    Q_OBJECT

public:
    /// The controllers outlive the observer.
    AttemptObserver(const AttemptContext& context, AttemptController& attempts, ResumeController& resume);

    /// Sets where the beginning of an exam is sent to; null: there is no database.
    void setUploader(AttemptUploader* uploader) { m_uploader = uploader; }

    /// Returns the hand that the student worked with for most of the attempt.
    [[nodiscard]] QString hand() const;
    /// Returns the kind of picture that the student saw for most of the attempt.
    [[nodiscard]] ui::render::Stereo picture() const;

private:
    void observe();
    void watchExam(const core::session::Findings& findings);

    AttemptContext m_context;
    AttemptController& m_attempts;
    ResumeController& m_resume;
    AttemptUploader* m_uploader = nullptr;
    QTimer m_timer;
    std::map<ui::render::Stereo, int> m_cutIn;  ///< observations during which the tooth was cut, by kind of picture
    std::map<QString, int> m_cutWith;           ///< the same, by id of the hand
};

}  // namespace app
