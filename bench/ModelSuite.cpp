// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <numeric>

#include "bench/Contestants.h"
#include "bench/Suites.h"
#include "core/bur/Bur.h"
#include "core/teeth/ToothBuilder.h"
#include "lab/ModelCost.h"

namespace bench {
namespace {

constexpr int kTooth = 36;
constexpr std::array kSides{75, 150, 225, 300, 450};
constexpr int kUndercutSide = 225;
constexpr int kReferenceSide = core::terrain::kMaxGridSide;

struct Model
{
    const char* key;
    const char* name;
    LookIndex look;
    lab::ModelCost (*mill)(const std::shared_ptr<const core::terrain::ToothAnatomy>&, std::size_t bur);
};
constexpr std::array<Model, 2> kModels{{
    {"stack", "height stack", 0, lab::millHeightStack},
    {"voxels", "dense voxels", 4,
     [](const std::shared_ptr<const core::terrain::ToothAnatomy>& anatomy, std::size_t bur) {
         return lab::millVoxels(*anatomy, bur);
     }},
}};

core::Result<std::shared_ptr<const core::terrain::ToothAnatomy>> toothAt(int side)
{
    core::teeth::BuildOptions options;
    options.gridSide = side;
    auto tooth = core::teeth::buildTooth({kTooth}, options);
    if (!tooth)
        return tl::unexpected(tooth.error());
    return tooth->anatomy;
}

double sumOf(const lab::ModelCost& cost)
{
    return std::accumulate(cost.removedMm3.begin(), cost.removedMm3.end(), 0.0);
}

/// Returns a chart with the error along y.
NamedChart chartOf(const QString& name, const QString& title, const ui::charts::Axis& x,
                   const QList<ui::charts::Line>& lines)
{
    ui::charts::Curve content;
    content.x = x;
    content.y = {QStringLiteral("volume removed, off by (% rms of 8 slots)"), 0.01, 10.0};
    content.x.base = content.y.base = 10.0;
    content.lines = lines;
    if (x.high > 1000.0)
        content.limits = {{1000.0, true, QStringLiteral("1 ms: the whole tick")}};
    return {name,
            {title,
             QStringLiteral(
                 "Generated tooth 36, root and all; straight fissure bur No. 57 mills slots 1 to 3 mm deep. Truth: "
                 "the height stack at grid 1024.\nBeside a marker: the cell, mm. Stack: anchor search and drill as "
                 "shipped. Voxels: one count of what is in the bur, and removal."),
             {},
             content}};
}

/// Measures what a height map removes although the bur was not there: the material over a wide head with a narrow neck.
core::Status addUndercut(Figures& figures, const char* name)
{
    const auto bur = core::bur::findBur(name);
    const auto tooth = toothAt(kUndercutSide);
    if (!bur || !tooth)
        return tl::unexpected(bur ? tooth.error() : bur.error());
    const double more = sumOf(lab::millHeightStack(*tooth, *bur)) / sumOf(lab::millVoxels(**tooth, *bur)) - 1.0;
    figures << Figure{QStringLiteral("model_undercut_%1_percent").arg(QLatin1String(name)),
                      QStringLiteral("bur %1: the stack takes more than voxels").arg(QLatin1String(name)), 100.0 * more,
                      QStringLiteral("%"), QString()};
    return {};
}

}  // namespace

core::Result<Figures> modelSuite(const Context& context)
{
    constexpr int kSteps = 2 + static_cast<int>(kSides.size());
    const auto bur = core::bur::findBur("57");
    if (!bur)
        return tl::unexpected(bur.error());
    context.progress(QStringLiteral("the true volumes, grid %1").arg(kReferenceSide), 0, kSteps);
    const auto finest = toothAt(kReferenceSide);
    if (!finest)
        return tl::unexpected(finest.error());
    const lab::ModelCost truth = lab::millHeightStack(*finest, *bur);

    Figures figures;
    QList<ui::charts::Line> bySize;
    for (const Model& model : kModels)
        bySize << lineOf(QLatin1String(model.name), model.look);
    QList<ui::charts::Line> byTime = bySize;
    for (std::size_t step = 0; step < kSides.size(); ++step) {
        const int side = kSides[step];
        context.progress(QStringLiteral("grid %1").arg(side), 1 + static_cast<int>(step), kSteps);
        const auto tooth = toothAt(side);
        if (!tooth)
            return tl::unexpected(tooth.error());
        for (std::size_t k = 0; k < kModels.size(); ++k) {
            const Model& model = kModels[k];
            const lab::ModelCost cost = model.mill(*tooth, *bur);
            const double mb = static_cast<double>(cost.bytes) * 1.0e-6;
            const double errorPercent = lab::volumeErrorPercent(cost, truth);
            const double p99 = cost.times.percentileUs(0.99);
            const auto add = [&](const char* what, double value, const char* unit) {
                figures << Figure{
                    QStringLiteral("model_%1_%2_%3").arg(QLatin1String(model.key)).arg(side).arg(QLatin1String(what)),
                    QStringLiteral("%1, grid %2 (%3 mm): %4")
                        .arg(QLatin1String(model.name))
                        .arg(side)
                        .arg((*tooth)->grid.cellMm, 0, 'g', 2)
                        .arg(QLatin1String(what)),
                    value, QLatin1String(unit), QString()};
            };
            add("size_mb", mb, "MB");
            add("p50_us", cost.times.percentileUs(0.5), "us");
            add("p99_us", p99, "us");
            add("volume_percent", errorPercent, "%");
            const auto at = static_cast<qsizetype>(k);
            const QString note = QString::number((*tooth)->grid.cellMm, 'g', 2);
            bySize[at].dots << pointAt(mb, errorPercent, note);
            byTime[at].dots << pointAt(p99, errorPercent, note);
        }
    }
    context.progress(QStringLiteral("undercuts"), kSteps - 1, kSteps);
    for (const char* name : {"2", "330"})
        if (const core::Status added = addUndercut(figures, name); !added)
            return tl::unexpected(added.error());
    context.show(chartOf(QStringLiteral("model-size"), QStringLiteral("Model size: height stack and dense voxels"),
                         {QStringLiteral("size of the tooth, cut and uncut (MB)"), 0.1, 1000.0}, bySize));
    context.show(chartOf(
        QStringLiteral("model-time"), QStringLiteral("Time a tick while cutting: height stack and dense voxels"),
        {QStringLiteral("thread CPU time of contact and removal in a tick, 99th percentile (us)"), 1.0, 2000.0},
        byTime));
    return figures;
}

}  // namespace bench
