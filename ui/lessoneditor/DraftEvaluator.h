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

/// Evaluates drafts of lessons on its own thread, one at a time. If several drafts are waiting, only the newest is
/// evaluated. Ui thread.
class DraftEvaluator final : public QObject
{
    Q_OBJECT
public:
    explicit DraftEvaluator(QObject* parent);
    ~DraftEvaluator() override;

    /// Requests the evaluation of a draft; weighed() follows.
    void weigh(const QJsonObject& draft, const QString& file);
    /// Cancels all requests, because another draft is about to be shown.
    void forget();
    /// Returns whether the result of the newest request is pending.
    [[nodiscard]] bool isBusy() const { return m_isAtWork && (m_isAnswerWanted || m_next); }

signals:
    /// Emitted when a draft has been evaluated.
    /// @param isNewest  no newer request is waiting
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
    bool m_isAnswerWanted = false;                   ///< the result of the running job has not been cancelled
    std::shared_ptr<const EvaluatedDraft> m_before;  ///< the newest result with an assignment; its tooth is reused if
                                                     ///< possible
    QThreadPool m_pool;                              ///< last: its destructor waits for a job that uses the members
                                                     ///< above
};

}  // namespace ui::lessoneditor
