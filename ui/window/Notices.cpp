// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/Notices.h"

#include <QDir>
#include <QFileInfo>

namespace ui::window {
namespace {

using kit::MessageBar;
using text::FailedOperation;

MessageBar::Topic topicOf(const core::Error& error, FailedOperation failed)
{
    switch (failed) {
    case FailedOperation::OpeningScan:
    case FailedOperation::MakingTooth:
    case FailedOperation::OpeningRecording:
        return MessageBar::Topic::Tooth;
    case FailedOperation::KeepingAttempt:
    case FailedOperation::KeepingExam:
        return MessageBar::Topic::Journal;
    case FailedOperation::ReadingSchool:
        return error.code == core::ErrorCode::ConnectionLost ? MessageBar::Topic::School : MessageBar::Topic::Page;
    default:
        return MessageBar::Topic::General;
    }
}

}  // namespace

void Notices::say(const QString& sentence)
{
    m_messages.say({MessageBar::Kind::News, sentence, {}, {}, {}});
}

void Notices::warn(const QString& sentence)
{
    m_messages.say({MessageBar::Kind::Warning, sentence, {}, {}, {}});
}

void Notices::sayUndoable(const QString& sentence, const std::function<void()>& undo)
{
    m_messages.say({MessageBar::Kind::News, sentence, {}, tr("Undo"), undo});
}

void Notices::showError(const core::Error& error, FailedOperation failed, const QString& file)
{
    showError(error, failed, file, topicOf(error, failed));
}

void Notices::showGradeNotSaved(const core::Error& error)
{
    m_messages.withdraw(MessageBar::Topic::Keeping);
    showError(error, FailedOperation::KeepingGrade, {}, MessageBar::Topic::Keeping);
}

void Notices::showError(const core::Error& error, FailedOperation failed, const QString& file, MessageBar::Topic topic)
{
    const QString exact = QString::fromStdString(error.detail);
    qWarning("%s", qPrintable(exact));
    const QString name = QFileInfo(file).fileName();
    // A teacher can correct a lesson file, so the message contains the detail with the key, as on the page of lessons.
    const QString detail =
        failed == FailedOperation::OpeningLesson && !name.isEmpty() ? name + QStringLiteral(": ") + exact : name;
    m_messages.say([=] {
        return MessageBar::Message{
            MessageBar::Kind::Error, text::errorText(error, failed), detail, {}, {}, topic, exact};
    });
}

void Notices::showDatabaseSilent()
{
    m_messages.withdraw(MessageBar::Topic::School);
    m_messages.say([] {
        return MessageBar::Message{MessageBar::Kind::Warning,
                                   tr("The school's database does not answer yet. You can continue drilling; your "
                                      "request is completed when it answers."),
                                   {},
                                   {},
                                   {},
                                   MessageBar::Topic::School};
    });
}

void Notices::showOverLimit(const QString& actionText, const std::function<void()>& save)
{
    m_messages.say({MessageBar::Kind::Warning,
                    tr("You had no attempts left at this lesson, so this grade is not saved."),
                    tr("You can save your work as a recording."), actionText, save, MessageBar::Topic::Tooth});
}

void Notices::showWrongFile(const QString& path)
{
    m_messages.say({MessageBar::Kind::Error,
                    tr("This is neither a scan (OBJ, STL, PLY) nor a recording. Drop one of those."),
                    QFileInfo(path).fileName(),
                    {},
                    {}});
}

void Notices::showRecordingSaved(const QString& path)
{
    say(tr("The recording was saved as %1.").arg(QDir::toNativeSeparators(path)));
}

void Notices::showScanNotes(const std::function<QStringList()>& notes,
                            const std::function<void(const QString& unit)>& chooseUnit)
{
    m_messages.say([notes, chooseUnit] {
        const QStringList now = notes();
        MessageBar::Message message{MessageBar::Kind::Warning, now.front(), {}, {}, {}, MessageBar::Topic::Tooth};
        if (now.size() > 1) {
            message.sentence = tr("%n note(s) about this scan", nullptr, static_cast<int>(now.size()));
            message.detail = now.join(u'\n');
        }
        if (chooseUnit == nullptr)
            return message;
        const auto choice = [&](const QString& words, const QString& unit) {
            return MessageBar::Choice{words, [chooseUnit, unit] { chooseUnit(unit); }};
        };
        message.actionText = tr("Another unit");
        message.choices = {choice(tr("Millimetres"), QStringLiteral("mm")),
                           choice(tr("Centimetres"), QStringLiteral("cm")), choice(tr("Inches"), QStringLiteral("in")),
                           choice(tr("Metres"), QStringLiteral("m")), MessageBar::Choice{tr("Keep this unit"), {}}};
        return message;
    });
}

}  // namespace ui::window
