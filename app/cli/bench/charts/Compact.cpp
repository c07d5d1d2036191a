// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/bench/charts/Compact.h"

#include <utility>

#include <QRegularExpression>

namespace app::cli::bench {
namespace {

/// Neighbouring groups with the same attributes become one.
QString joined(const QString& svg)
{
    static const QRegularExpression group(QStringLiteral("<g ([^>]*)>\\s*((?:<(?!/?g)[^>]*>\\s*)+)</g>\\s*"));
    QString all;
    QString open;
    qsizetype copied = 0;
    for (auto found = group.globalMatch(svg); found.hasNext();) {
        const QRegularExpressionMatch match = found.next();
        const QString between = svg.mid(copied, match.capturedStart() - copied);
        if (!open.isEmpty() && (!between.isEmpty() || open != match.captured(1))) {
            all += QStringLiteral("</g>\n");
            open.clear();
        }
        all += between;
        if (open.isEmpty()) {
            open = match.captured(1);
            all += QStringLiteral("<g ") + open + QStringLiteral(">\n");
        }
        all += match.captured(2);
        copied = match.capturedEnd();
    }
    if (!open.isEmpty())
        all += QStringLiteral("</g>\n");
    return all + svg.mid(copied);
}

}  // namespace

QByteArray compacted(const QByteArray& svg, const QString& family)
{
    static const std::pair<QRegularExpression, QString> kChanges[] = {
        {QRegularExpression(QStringLiteral("<g [^>]*>\\s*</g>\\s*")), {}},
        // Every text brings its own font, and no line needs one.
        {QRegularExpression(QStringLiteral("\nfont-family=\"[^\"]*\" font-size=\"[^\"]*\" font-weight=\"[^\"]*\" "
                                           "font-style=\"[^\"]*\" \n(?=>)")),
         {}},
        {QRegularExpression(QStringLiteral(" transform=\"matrix\\(1,0,0,1,0,0\\)\"")), {}},
        {QRegularExpression(QStringLiteral("matrix\\(1,0,0,1,([^)]*)\\)")), QStringLiteral("translate(\\1)")},
        {QRegularExpression(QStringLiteral(" (?:fill|stroke)-opacity=\"1\"")), {}},
        // Texts bring their colour too, and have no outline.
        {QRegularExpression(QStringLiteral("<g [^>]*(transform=\"[^\"]*\")>\\s*<text ([^>]*?)\\s*>([^<]*)</text>")),
         QStringLiteral("<g \\1><text \\2>\\3</text>")},
        {QRegularExpression(QStringLiteral("(?: xml:space=\"preserve\"| x=\"0\"(?= y)| font-style=\"normal\"| "
                                           "font-weight=\"400\"| font-family=\"[^\"]*\")")),
         {}},
    };
    QString text = QString::fromUtf8(svg);
    for (const auto& [pattern, change] : kChanges)
        text.replace(pattern, change);
    text.replace(text.indexOf(QStringLiteral("<g ")), 3,
                 QStringLiteral("<g font-family=\"%1, DejaVu Sans, Arial, sans-serif\" ").arg(family));
    return joined(text).toUtf8();
}

}  // namespace app::cli::bench
