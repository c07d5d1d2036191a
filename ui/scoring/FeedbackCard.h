// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QString>

class QLabel;
class QPushButton;

namespace ui::scoring {

/// On a student's home: that a teacher has said something of his work which he has not read yet.
class FeedbackCard final : public QFrame
{
    Q_OBJECT
public:
    explicit FeedbackCard(QWidget* parent);

    /// @param attempts  of which there is something new; hidden where there are none
    /// @param lesson, author  of the newest
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
