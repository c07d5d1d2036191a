// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include <QJsonObject>
#include <QObject>
#include <QString>
#include <QThreadPool>

namespace ui::lessoneditor {

struct EvaluatedDraft;

/// Weighs drafts on a thread of its own, one at a time and of those that wait only the newest. Ui thread.
class DraftEvaluator final : public QObject
{
    Q_OBJECT
public:
    explicit DraftEvaluator(QObject* parent);
    ~DraftEvaluator() override;

    void weigh(const QJsonObject& draft, const QString& file);
    /// Another draft is next: what is under way is about one that nobody asks about any more.
    void forget();
    /// The answer to the newest wish is still to come.
    [[nodiscard]] bool isBusy() const { return m_isAtWork && (m_isAnswerWanted || m_next); }

signals:
    /// @param isNewest  nothing else has been asked for meanwhile
    void weighed(const std::shared_ptr<const EvaluatedDraft>& found, bool isNewest);

private:
    struct Wish
    {
        QJsonObject draft;
        QString file;
    };

    void start(const Wish& wish);
    void take(const std::shared_ptr<const EvaluatedDraft>& found);

    std::optional<Wish> m_next;
    bool m_isAtWork = false;
    bool m_isAnswerWanted = false;                   ///< of what is at work
    std::shared_ptr<const EvaluatedDraft> m_before;  ///< the newest that is a lesson: its tooth may serve again
    QThreadPool m_pool;                              ///< last: waited for before what it answers to goes away
};

}  // namespace ui::lessoneditor
