// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/render/Wishes.h"

#include <cmath>

#include "cli/parts/Arguments.h"
#include "ui/tooth/Viewpoint.h"

namespace cli {
namespace {

/// Returns the requested kind of picture, or an error if other options do not apply to it.
core::Result<Picture> kindOf(const QCommandLineParser& parser)
{
    QStringList asked;
    Picture kind = Picture::Tooth;
    const QStringList flat{QStringLiteral("section"), QStringLiteral("xray"), QStringLiteral("bitewing"),
                           QStringLiteral("arch")};
    for (int k = 0; k < flat.size(); ++k) {
        if (!parser.isSet(flat[k]))
            continue;
        asked << QStringLiteral("--") + flat[k];
        kind = static_cast<Picture>(k + 1);
    }
    if (asked.size() > 1)
        return core::unexpected(core::ErrorCode::UnknownName,
                                asked.join(u" and ").toStdString() + " are pictures of their own; ask for one");
    const bool isFilm = kind == Picture::Xray || kind == Picture::Bitewing;
    for (const char* option : {"angle", "exposure"})
        if (!isFilm && parser.isSet(QLatin1String(option)))
            return core::unexpected(core::ErrorCode::UnknownName,
                                    std::string("--") + option + " is about an X-ray picture: --xray or --bitewing");
    if (kind == Picture::Tooth)
        return kind;
    for (const char* option : {"view", "stereo", "flip"})
        if (parser.isSet(QLatin1String(option)))
            return core::unexpected(core::ErrorCode::UnknownName, std::string("--") + option +
                                                                      " is about the tooth in space and means nothing "
                                                                      "with " +
                                                                      asked.front().toStdString());
    const QString show = parser.value(QStringLiteral("show"));
    QStringList known;
    if (kind == Picture::Section)
        known << QStringLiteral("distinct") << QStringLiteral("prepared");
    else if (kind == Picture::Xray)
        known << QStringLiteral("before") << QStringLiteral("prepared");
    for (const QString& what : show.split(u',', Qt::SkipEmptyParts))
        if (!known.contains(what))
            return core::unexpected(core::ErrorCode::UnknownName,
                                    known.isEmpty() ? "--show means nothing with " + asked.front().toStdString()
                                                    : "with " + asked.front().toStdString() + ", --show knows only " +
                                                          known.join(u" and ").toStdString());
    return kind;
}

}  // namespace

void addRenderOptions(QCommandLineParser& parser)
{
    const auto option = [&](const char* name, const char* help, const char* value) {
        parser.addOption({QLatin1String(name), QLatin1String(help), QLatin1String(value)});
    };
    option("tooth", "A mesh file, an FDI number or a practice block such as block:line.", "FILE|FDI");
    option(
        "recording",
        "Draws what this attempt left of its tooth, and its bur. A --tooth beside it must be the one it was made on.",
        "FILE");
    parser.addOption({QStringLiteral("view"),
                      QStringLiteral("From where: %1, or AZ,EL,DIST in degrees, degrees and mm. Azimuth 0 looks along "
                                     "+y; it grows as the eye moves towards +x.")
                          .arg(ui::tooth::viewpointNames().join(QStringLiteral(", "))),
                      QStringLiteral("NAME|AZ,EL,DIST"), QStringLiteral("start")});
    parser.addOption({QStringLiteral("size"), QStringLiteral("Of the picture in pixels; 1280x800 if not given."),
                      QStringLiteral("WxH"), QStringLiteral("1280x800")});
    option("section",
           "Draws, instead, the upright cut through the bur or the middle of the tooth, so many degrees from +x to +y.",
           "ANGLE");
    parser.addOption({QStringLiteral("xray"), QStringLiteral("Draws, instead, an X-ray picture from the side.")});
    parser.addOption({QStringLiteral("bitewing"),
                      QStringLiteral("Draws, instead, an X-ray picture of the crown between its two neighbours.")});
    parser.addOption({QStringLiteral("arch"),
                      QStringLiteral("Draws, instead, the whole mouth; a --tooth of it by its FDI number is marked.")});
    option("angle", "Of the beam of an X-ray picture, degrees from square: -90 to 90; 0 if not given.", "DEG");
    option("exposure", "Of an X-ray picture, times the usual: 0.25 to 4; 1 if not given.", "TIMES");
    option("stereo", "For two eyes: red-cyan, grey (for the same glasses), side-by-side or top-bottom.", "MODE");
    option("flip", "Turns the picture over: left-right, up-down or both.", "WHICH");
    option(
        "show",
        "What is drawn besides, several with commas: mirror, distinct (colours and patterns that nobody "
        "confuses), wet, light (of the handpiece), depth (the cut coloured by its depth), ideal (coloured by how "
        "much it is too deep, or is still to go), neighbours (the teeth beside it), gizmo (which side is where), "
        "hand (of a recording: where the hand holds the bur), left-hand (the other hand works), prepared (cut as the "
        "ideal says); with --xray: before (the whole tooth beside it).",
        "WHAT");
    option("ideal",
           "What ought to be cut, for --show ideal and prepared: class1, class1-buccal, class2-mesial, class2-distal, "
           "slot-mesial, slot-distal, access or occlusal-reduction. If not given, the shape of a block, and on a tooth "
           "the decay.",
           "NAME");
    option("out", "The picture.", "FILE.png");
    addToothOptions(parser);
}

core::Result<RenderWishes> renderWishes(const QCommandLineParser& parser)
{
    using ui::render::Stereo;
    RenderWishes wishes;
    wishes.ideal = parser.value(QStringLiteral("ideal")).toStdString();
    const auto kind = kindOf(parser);
    if (!kind)
        return tl::unexpected(kind.error());
    wishes.kind = *kind;
    if (*kind == Picture::Section) {
        bool isNumber = false;
        wishes.sectionDeg = parser.value(QStringLiteral("section")).toDouble(&isNumber);
        if (!isNumber || !(std::abs(wishes.sectionDeg) <= 360.0))
            return core::unexpected(core::ErrorCode::OutOfRange, "--section wants degrees from -360 to 360");
    }
    const auto number = [&](const char* option, double low, double high, double& value) {
        bool isNumber = true;
        if (parser.isSet(QLatin1String(option)))
            value = parser.value(QLatin1String(option)).toDouble(&isNumber);
        return isNumber && value >= low && value <= high;
    };
    if (!number("angle", -90.0, 90.0, wishes.beamDeg))
        return core::unexpected(core::ErrorCode::OutOfRange, "--angle wants degrees from -90 to 90");
    if (!number("exposure", 0.25, 4.0, wishes.exposure))
        return core::unexpected(core::ErrorCode::OutOfRange, "--exposure wants a number from 0.25 to 4");
    const QString stereo = parser.value(QStringLiteral("stereo"));
    const QStringList modes{QString(), QStringLiteral("red-cyan"), QStringLiteral("grey"),
                            QStringLiteral("side-by-side"), QStringLiteral("top-bottom")};
    if (!modes.contains(stereo) || (stereo.isEmpty() && parser.isSet(QStringLiteral("stereo"))))
        return core::unexpected(core::ErrorCode::UnknownName,
                                "--stereo wants one of" + modes.join(u", ").mid(1).toStdString());
    wishes.presentation.stereo = static_cast<Stereo>(modes.indexOf(stereo));
    if (const QString flip = parser.value(QStringLiteral("flip")); parser.isSet(QStringLiteral("flip"))) {
        wishes.presentation.flipLeftRight = flip == u"left-right" || flip == u"both";
        wishes.presentation.flipUpDown = flip == u"up-down" || flip == u"both";
        if (!wishes.presentation.flipLeftRight && !wishes.presentation.flipUpDown)
            return core::unexpected(core::ErrorCode::UnknownName, "--flip wants left-right, up-down or both");
    }
    for (const QString& what : parser.value(QStringLiteral("show")).split(u',', Qt::SkipEmptyParts)) {
        if (what == u"mirror")
            wishes.mirror = true;
        else if (what == u"distinct")
            wishes.look.palette = ui::render::Palette::Distinct;
        else if (what == u"wet")
            wishes.look.isWet = true;
        else if (what == u"light")
            wishes.look.burLight = true;
        else if (what == u"depth")
            wishes.look.depthColours = ui::render::DepthColours::BelowOriginal;
        else if (what == u"ideal")
            wishes.look.depthColours = ui::render::DepthColours::AgainstIdeal;
        else if (what == u"neighbours")
            wishes.neighbours = true;
        else if (what == u"gizmo")
            wishes.gizmo = true;
        else if (what == u"hand")
            wishes.hand = true;
        else if (what == u"left-hand")
            wishes.leftHand = true;
        else if (what == u"prepared")
            wishes.prepared = true;
        else if (what == u"before" && *kind == Picture::Xray)
            wishes.before = true;
        else
            return core::unexpected(core::ErrorCode::UnknownName,
                                    "--show knows mirror, distinct, wet, light, depth, ideal, neighbours, gizmo, "
                                    "hand, left-hand and prepared, but not \"" +
                                        what.toStdString() + "\"");
    }
    return wishes;
}

}  // namespace cli
