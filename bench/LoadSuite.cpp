// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <filesystem>
#include <optional>

#include <QFileInfo>
#include <QRegularExpression>

#include "bench/Suites.h"
#include "core/teeth/ToothBuilder.h"

namespace bench {
namespace {

constexpr int kRuns = 5;

/// Returns the shortest of some runs, milliseconds: the time of the work without disturbance.
core::Result<double> shortestLoadMs(const core::teeth::ToothSource& source)
{
    std::optional<double> best;
    for (int run = 0; run < kRuns; ++run) {
        const auto tooth = core::teeth::buildTooth(source, {});
        if (!tooth)
            return tl::unexpected(tooth.error());
        best = std::min(best.value_or(tooth->report.loadMs), tooth->report.loadMs);
    }
    return *best;
}

}  // namespace

core::Result<Figures> loadSuite(const Context& context)
{
    Figures figures;
    const auto steps = 3 + static_cast<int>(context.meshes.size());
    int done = 0;
    for (const int fdi : {21, 24, 36}) {
        context.progress(QStringLiteral("tooth %1").arg(fdi), done++, steps);
        const auto ms = shortestLoadMs({fdi});
        if (!ms)
            return tl::unexpected(ms.error());
        figures << Figure{QStringLiteral("load_generated_%1_ms").arg(fdi),
                          QStringLiteral("generate tooth %1, maps, layers, caries").arg(fdi),
                          *ms,
                          QStringLiteral("ms"),
                          {}};
    }
    for (const QString& mesh : context.meshes) {
        context.progress(mesh, done++, steps);
        const auto ms = shortestLoadMs({std::filesystem::path(mesh.toStdString())});
        if (!ms)
            return tl::unexpected(ms.error());
        const QFileInfo file(mesh);
        static const QRegularExpression notForKeys(QStringLiteral("[^a-z0-9]+"));
        figures << Figure{QStringLiteral("load_%1_ms")
                              .arg(file.completeBaseName().toLower().replace(notForKeys, QStringLiteral("_"))),
                          QStringLiteral("read %1, maps, layers, caries").arg(file.fileName()), *ms,
                          QStringLiteral("ms"), QStringLiteral("under 150")};
    }
    return figures;
}

}  // namespace bench
