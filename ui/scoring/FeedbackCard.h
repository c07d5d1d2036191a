// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QString>

class QLabel;
class QPushButton;

namespace ui::scoring {

/// A card on a student's home page that shows unread comments of a teacher on their attempts.
class FeedbackCard final : public QFrame
{
    Q_OBJECT
public:
    explicit FeedbackCard(QWidget* parent);

    /// @param attempts  number of attempts with unread comments; 0 hides the card
    /// @param lesson, author  of the newest comment
    void setNews(int attempts, const QString& lesson, const QString& author);

signals:
    void readRequested();

private:
    void tell();

    int m_attempts = 0;
    QString m_lesson;
    QString m_author;
    QLabel* m_words;
    QPushButton* m_read;
};

}  // namespace ui::scoring
