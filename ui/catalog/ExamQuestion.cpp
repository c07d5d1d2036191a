// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/catalog/ExamQuestion.h"

#include <utility>

#include <QCoreApplication>
#include <QStringList>

#include "ui/text/LessonTexts.h"
#include "ui/text/Texts.h"

namespace ui::catalog {
namespace {

struct ExamWords
{
    Q_DECLARE_TR_FUNCTIONS(ui::catalog::ExamQuestion)
};

}  // namespace

kit::ConfirmOverlay::Question examQuestion(const ::lessons::Lesson& exam, const QString& attempts,
                                           std::function<void()> begin)
{
    // Every exam locks these aids.
    QStringList locked{ExamWords::tr("undo"), ExamWords::tr("expert's attempt"), ExamWords::tr("earlier attempts")};
    locked << text::lockedAids(exam.aids);
    const QStringList detail{
        //: %1: "8 min", or that there is no limit
        ExamWords::tr("Time: %1").arg(text::timeWords(exam)),
        //: %1: "2 attempts left, 1 graded so far"
        ExamWords::tr("Attempts: %1").arg(attempts),
        //: %1: points
        ExamWords::tr("Passed from: %1 of 100 points").arg(text::points(exam.rubric.passMarkTenths)),
        //: %1: a list
        ExamWords::tr("Locked: %1").arg(locked.join(QStringLiteral(", "))),
        QString(),
        ExamWords::tr("The clock starts when you begin, and also runs while you are on another page. Faults are shown "
                      "after the grade."),
    };
    kit::ConfirmOverlay::Question question;
    question.text = text::said(exam.title);
    question.detail = detail.join(u'\n');
    question.drawing = QStringLiteral("grade");
    question.saveText = ExamWords::tr("&Begin exam");
    question.save = std::move(begin);
    return question;
}

}  // namespace ui::catalog
