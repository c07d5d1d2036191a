// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/attempt/ScoreAnalysis.h"

#include <utility>

#include "ui/scoring/ScorePage.h"

namespace app {
namespace {

constexpr double kShareAStep = 0.02;  ///< smallest progress that is reported

}  // namespace

ScoreAnalysis::ScoreAnalysis(QObject* parent) : QObject(parent)
{
    m_pool.setMaxThreadCount(1);
    m_pool.setThreadPriority(QThread::LowPriority);
}

ScoreAnalysis::~ScoreAnalysis()
{
    forget();
    m_pool.waitForDone();
}

void ScoreAnalysis::forget()
{
    if (m_goOn)
        m_goOn->store(false, std::memory_order_relaxed);
    m_goOn.reset();
    m_share = 0.0;
    m_noise.reset();
    m_moments.reset();
}

void ScoreAnalysis::explain(const lessons::Assignment& assignment, const core::recording::Recording& recording,
                            std::shared_ptr<const core::terrain::Tooth> tooth, const lessons::Conduct& conduct)
{
    forget();
    m_goOn = std::make_shared<std::atomic<bool>>(true);
    emit momentsProgress(0.0);
    // `this` stays valid during the work, because the destructor waits for the pool. `goOn` is false once the analysis
    // has been cancelled.
    m_pool.start([this, goOn = m_goOn, assignment, recording, tooth = std::move(tooth), conduct] {
        const auto tell = [this, goOn](auto what) {
            QMetaObject::invokeMethod(
                this,
                [goOn, what = std::move(what)] {
                    if (goOn->load(std::memory_order_relaxed))
                        what();
                },
                Qt::QueuedConnection);
        };
        tell([this, noise = lessons::gridNoise(assignment, *tooth, conduct)] { takeNoise(noise); });
        double told = 0.0;
        auto found = lessons::momentsOf(assignment, recording, [&](double share) {
            if (share >= told + kShareAStep) {
                told = share;
                tell([this, share] { emit momentsProgress(m_share = share); });
            }
            return goOn->load(std::memory_order_relaxed);
        });
        tell([this, found = std::move(found)] { takeMoments(found); });
    });
}

void ScoreAnalysis::takeNoise(const core::Result<lessons::GridSensitivity>& found)
{
    if (found)
        emit noiseFound(*(m_noise = *found));
    else
        emit failed(found.error());
}

void ScoreAnalysis::takeMoments(const core::Result<std::optional<lessons::PointLossTimeline>>& found)
{
    m_share = 1.0;
    if (!found) {
        emit failed(found.error());
    } else if (*found) {
        m_moments = **found;
        emit momentsFound(*m_moments);
    }
}

void ScoreAnalysis::emitFound()
{
    if (m_noise)
        emit noiseFound(*m_noise);
    if (m_moments)
        emit momentsFound(*m_moments);
    else if (m_goOn && m_share < 1.0)
        emit momentsProgress(m_share);
}

void ScoreAnalysis::showOn(ui::scoring::ScorePage& page, const std::function<bool()>& isShown)
{
    connect(this, &ScoreAnalysis::noiseFound, &page, [&page, isShown](const lessons::GridSensitivity& noise) {
        if (isShown())
            page.setNoise(noise);
    });
    connect(this, &ScoreAnalysis::momentsProgress, &page, [&page, isShown](double share) {
        if (isShown())
            page.setMomentsProgress(share);
    });
    connect(this, &ScoreAnalysis::momentsFound, &page, [&page, isShown](const lessons::PointLossTimeline& moments) {
        if (isShown())
            page.setMoments(moments.ofCriteria);
    });
    connect(this, &ScoreAnalysis::failed, &page, [&page, isShown] {
        if (isShown())
            page.setMomentsProgress({});
    });
}

}  // namespace app
