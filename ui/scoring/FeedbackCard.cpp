// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scoring/FeedbackCard.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include "ui/kit/Theme.h"
#include "ui/text/EveryLanguage.h"

namespace ui::scoring {

using namespace kit;

FeedbackCard::FeedbackCard(QWidget* parent) : QFrame(parent), m_words(new QLabel(this)), m_read(new QPushButton(this))
{
    setProperty("kind", "card");
    setObjectName(QStringLiteral("feedbackCard"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(kSpace4, kSpace2, kSpace2, kSpace2);
    m_words->setObjectName(QStringLiteral("feedbackWords"));
    m_words->setFont(typeface(kBody, QFont::Medium));
    m_words->setWordWrap(true);
    m_words->setTextFormat(Qt::PlainText);
    row->addWidget(m_words, 1);
    m_read->setObjectName(QStringLiteral("readFeedback"));
    m_read->setAutoDefault(true);
    row->addWidget(m_read);
    connect(m_read, &QPushButton::clicked, this, &FeedbackCard::readRequested);
    text::bindTranslation(this, [this] { tell(); });
    hide();
}

void FeedbackCard::setNews(int attempts, const QString& lesson, const QString& author)
{
    m_attempts = attempts;
    m_lesson = lesson;
    m_author = author;
    tell();
    setVisible(attempts > 0);
}

void FeedbackCard::tell()
{
    //: %1: a teacher; %2: a lesson
    const QString one = tr("%1 commented on your attempt: %2").arg(m_author, m_lesson);
    m_words->setText(m_attempts == 1 ? one : tr("%n of your attempts have new feedback", nullptr, m_attempts));
    m_read->setText(m_attempts == 1 ? tr("Read") : tr("My attempts"));
    m_read->setAccessibleName(m_read->text());
    m_read->setAccessibleDescription(m_words->text());
}

}  // namespace ui::scoring
