// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/bench/Suites.h"
#include "core/drilling/Bur.h"
#include "core/terrain/Grid.h"
#include "lab/ContactScene.h"

namespace app::cli::bench {
namespace {

constexpr double kStiffnessNPerMm = 2.0;

}  // namespace

core::Result<Figures> contactSuite(const Context& context)
{
    Figures figures;
    for (const char* bur : {"2", "330"}) {
        const auto index = core::drilling::findBur(bur);
        if (!index)
            return tl::unexpected(index.error());
        for (const lab::ContactFamily& family : lab::contactFamilies(core::terrain::kDefaultGridSide, *index)) {
            const QString name = QString::fromStdString(family.name);
            context.progress(QStringLiteral("bur %1, %2").arg(QLatin1String(bur), name));
            for (const char* method : {"continuous", "lattice", "penalty"}) {
                const lab::ContactErrors errors = lab::measureContact(family, method, kStiffnessNPerMm);
                const auto add = [&](const char* what, double value, const char* unit, double reach) {
                    QString key = QStringLiteral("contact_%1_%2_%3_%4")
                                      .arg(QLatin1String(method), QLatin1String(bur), name, QLatin1String(what));
                    figures << Figure{key.replace(u' ', u'_').replace(u'.', u'_'),
                                      QStringLiteral("%1, bur %2, %3: %4")
                                          .arg(QLatin1String(method), QLatin1String(bur), name, QLatin1String(what)),
                                      value, QLatin1String(unit),
                                      qstrcmp(method, "continuous") == 0 ? QStringLiteral("under %1").arg(reach)
                                                                         : QString()};
                };
                add("rms_um", errors.rmsUm, "um", family.reachRmsUm);
                add("most_um", errors.mostUm, "um", family.reachMostUm);
                add("jump_n", errors.jumpN, "N", family.reachJumpN);
                add("tick_us", errors.tickUs, "us", 5.0);
            }
        }
        for (const int cells : {1, 2})
            for (const char* method : {"continuous", "lattice", "penalty"})
                figures << Figure{QStringLiteral("contact_%1_%2_ridge_%3_holds_n")
                                      .arg(QLatin1String(method), QLatin1String(bur))
                                      .arg(cells),
                                  QStringLiteral("%1, bur %2, ridge of %3 cells: holds")
                                      .arg(QLatin1String(method), QLatin1String(bur))
                                      .arg(cells),
                                  lab::ridgeHoldsN(method, cells, *index, kStiffnessNPerMm), QStringLiteral("N"),
                                  qstrcmp(method, "continuous") == 0 ? QStringLiteral("at least 4") : QString()};
    }
    return figures;
}

}  // namespace app::cli::bench
