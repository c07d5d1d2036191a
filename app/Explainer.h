// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <memory>
#include <optional>

#include <QObject>
#include <QThreadPool>

#include "core/recording/Recording.h"
#include "lessons/Moments.h"

namespace app {

/// Finds out in the background what a score does not say by itself, on one thread of low priority. Its owner's thread;
/// signals come there.
class Explainer final : public QObject
{
    Q_OBJECT
public:
    explicit Explainer(QObject* parent = nullptr);
    ~Explainer() override;

    /// Begins with another attempt; what goes on about the one before is left off.
    void explain(const lessons::Assignment& assignment, const core::recording::Recording& recording);
    /// Says again what has been found so far.
    void tellAgain();
    /// Leaves off; what was found is forgotten.
    void forget();

signals:
    void momentsProgress(double share);
    void momentsFound(const lessons::Moments& moments);
    void failed(const core::Error& error);

private:
    void take(const core::Result<std::optional<lessons::Moments>>& found);

    QThreadPool m_pool;
    std::shared_ptr<std::atomic<bool>> m_goOn;  ///< of the attempt that is looked at; null: none
    double m_share = 0.0;
    std::optional<lessons::Moments> m_moments;
};

}  // namespace app
