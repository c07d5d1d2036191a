// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/Theme.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QApplication>
#include <QFile>
#include <QFontDatabase>
#include <QFrame>
#include <QLocale>
#include <QStyleFactory>
#include <QToolTip>
#include <QWidget>

#include "ui/kit/AppSettings.h"

namespace ui::kit {
namespace {

struct Colours
{
    QRgb window, base, button, hover, line, text, quiet, faint, fill, accentText;
};

constexpr Colours kLight{0xFFF3F5F5, 0xFFFFFFFF, 0xFFFFFFFF, 0xFFE6EBEB, 0xFFC9D1D1,
                         0xFF1A2223, 0xFF526061, 0xFF98A3A4, 0xFF0B7577, 0xFF0B7577};
constexpr Colours kDark{0xFF191C1D, 0xFF222627, 0xFF2B3031, 0xFF363C3D, 0xFF454C4E,
                        0xFFE8ECEC, 0xFFA6B0B1, 0xFF6D7678, 0xFF0B7577, 0xFF56C7C9};
constexpr Colours kRoom{0xFF1D1F20, 0xFF27292B, 0xFF303335, 0xFF3C4042, 0xFF484C4E,
                        0xFFECEEEE, 0xFFA9AFB1, 0xFF72787A, 0xFF0B7577, 0xFF56C7C9};

const QString kTheme = QStringLiteral("window/theme");
const QString kLightWord = QStringLiteral("light");
const QString kDarkWord = QStringLiteral("dark");

QPalette paletteOf(const Colours& c)
{
    QPalette p;
    const auto set = [&p](QPalette::ColorRole role, QRgb colour) { p.setColor(QPalette::All, role, QColor(colour)); };
    set(QPalette::Window, c.window);
    set(QPalette::WindowText, c.text);
    set(QPalette::Base, c.base);
    set(QPalette::AlternateBase, c.window);
    set(QPalette::Text, c.text);
    set(QPalette::Button, c.button);
    set(QPalette::ButtonText, c.text);
    set(QPalette::BrightText, 0xFFFFFFFF);
    set(QPalette::Light, c.hover);
    set(QPalette::Midlight, c.hover);
    set(QPalette::Mid, c.line);
    set(QPalette::Dark, c.line);
    set(QPalette::Shadow, 0xFF000000);
    set(QPalette::Highlight, c.fill);
    set(QPalette::HighlightedText, 0xFFFFFFFF);
    set(QPalette::Link, c.accentText);
    set(QPalette::LinkVisited, c.accentText);
    set(QPalette::ToolTipBase, c.base);
    set(QPalette::ToolTipText, c.text);
    set(QPalette::PlaceholderText, c.quiet);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        p.setColor(QPalette::Disabled, role, QColor(c.faint));
    p.setColor(QPalette::Disabled, QPalette::Highlight, QColor(c.line));
    return p;
}

/// Returns the style sheet with every palette(role) replaced by that palette's colour. palette(faint) is for less
/// important text.
QString sheetFor(const QPalette& palette)
{
    const QList<std::pair<QString, QColor>> roles{
        {"window-text", palette.color(QPalette::WindowText)},
        {"text", palette.color(QPalette::Text)},
        {"button-text", palette.color(QPalette::ButtonText)},
        {"highlighted-text", palette.color(QPalette::HighlightedText)},
        {"base", palette.color(QPalette::Base)},
        {"button", palette.color(QPalette::Button)},
        {"mid", palette.color(QPalette::Mid)},
        {"midlight", palette.color(QPalette::Midlight)},
        {"link", palette.color(QPalette::Link)},
        {"highlight", palette.color(QPalette::Highlight)},
        {"faint", palette.color(QPalette::Disabled, QPalette::ButtonText)},
    };
    QFile file(QStringLiteral(":/ui/cusp.qss"));
    if (!file.open(QIODevice::ReadOnly))
        return {};
    QString sheet = QString::fromUtf8(file.readAll());
    for (const auto& [role, colour] : roles)
        sheet.replace(QStringLiteral("palette(%1)").arg(role), colour.name());
    return sheet;
}

double luminance(const QColor& colour)
{
    const auto linear = [](double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); };
    return 0.2126 * linear(static_cast<double>(colour.redF())) + 0.7152 * linear(static_cast<double>(colour.greenF())) +
           0.0722 * linear(static_cast<double>(colour.blueF()));
}

}  // namespace

ThemeChoice rememberedTheme()
{
    const QString word = memory().value(kTheme).toString();
    return word == kLightWord ? ThemeChoice::Light : word == kDarkWord ? ThemeChoice::Dark : ThemeChoice::System;
}

void rememberTheme(ThemeChoice choice)
{
    if (choice == ThemeChoice::System)
        memory().remove(kTheme);
    else
        memory().setValue(kTheme, choice == ThemeChoice::Light ? kLightWord : kDarkWord);
}

void applyTheme(QApplication& application, ThemeChoice choice)
{
    const bool dark = choice == ThemeChoice::System ? isDark(QGuiApplication::palette()) : choice == ThemeChoice::Dark;
    // Without this attribute, widgets with a style sheet do not inherit the palette of their page.
    QCoreApplication::setAttribute(Qt::AA_UseStyleSheetPropagationInWidgetStyles);
    QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
    const QPalette palette = pagePalette(dark);
    QApplication::setPalette(palette);
    QToolTip::setPalette(palette);
    QFont family = QApplication::font();
    if (QFontDatabase::families().contains(QStringLiteral("Inter")))
        // VL PGothic comes before VL Gothic, because Qt cannot make a fixed-pitch font bold.
        family.setFamilies({QStringLiteral("Inter"), QStringLiteral("VL PGothic")});
    family.setPixelSize(kBody);
    QApplication::setFont(family);
    application.setStyleSheet(sheetFor(palette));
}

QPalette pagePalette(bool dark)
{
    return paletteOf(dark ? kDark : kLight);
}

QPalette roomPalette()
{
    return paletteOf(kRoom);
}

void dress(QWidget& widget, const QPalette& palette)
{
    widget.setPalette(palette);
    widget.setStyleSheet(sheetFor(palette));
}

bool isDark(const QPalette& palette)
{
    // Uses the text colour. The background of a child may be wrong: a style sheet makes it transparent black, or leaves
    // the background of another page.
    return palette.color(QPalette::WindowText).lightnessF() > 0.5F;
}

Tones tones(const QPalette& palette)
{
    if (isDark(palette))
        return {QColor(0xFF23A8AA), QColor(0xFFE0932A), QColor(0xFFF2B35C), QColor(0xFFE0604B), QColor(0xFFFF9C8A)};
    return {QColor(0xFF0F8B8D), QColor(0xFFC77700), QColor(0xFF8F5500), QColor(0xFFC6402B), QColor(0xFFB03522)};
}

QFont typeface(int pixelSize, QFont::Weight weight)
{
    QFont f = QApplication::font();
    f.setPixelSize(pixelSize);
    // The Japanese font has one weight, so Qt can only make it bold or leave it regular.
    f.setWeight(weight >= QFont::DemiBold && QLocale().language() == QLocale::Japanese ? QFont::Bold : weight);
    return f;
}

QFrame* line(QWidget* parent)
{
    auto* rule = new QFrame(parent);
    rule->setProperty("kind", "line");
    return rule;
}

QString brokenIntoLines(const QString& words)
{
    return words.isEmpty() ? QString() : QStringLiteral("<p>%1</p>").arg(words.toHtmlEscaped());
}

double contrast(const QColor& a, const QColor& b)
{
    const auto [low, high] = std::minmax({luminance(a), luminance(b)});
    return (high + 0.05) / (low + 0.05);
}

}  // namespace ui::kit
