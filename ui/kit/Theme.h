// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QFont>
#include <QPalette>
#include <QString>

class QApplication;
class QFrame;
class QWidget;

/// The looks of every page, in one place: palettes, a handful of tokens and one style sheet (ui/assets/cusp.qss).
///
/// Palette roles mean the same everywhere, so that one style sheet serves both rooms and both themes:
///   Window page, Base card, Button control, Mid line, Midlight hovered control, WindowText words,
///   PlaceholderText quiet words, Highlight filled button and slider, Link accent as words and focus ring.
namespace ui::kit {

enum class ThemeChoice { System, Light, Dark };

/// Spacing and corner, px.
inline constexpr int kSpace1 = 4;
inline constexpr int kSpace2 = 8;
inline constexpr int kSpace4 = 16;
inline constexpr int kSpace6 = 24;
inline constexpr int kBelowMessagePx = 88;  ///< from the top of the view: what lies below the place of a message
inline constexpr int kRadius = 6;

/// Type sizes, px. kHero is for one number a page.
inline constexpr int kSmall = 12;
inline constexpr int kBody = 14;
inline constexpr int kTitle = 18;
inline constexpr int kFigure = 28;
inline constexpr int kHero = 72;

/// What a palette has no role for. Shapes in these colours reach 3:1 on their page, words 4.5:1.
struct Tones
{
    QColor accent;         ///< shapes: bars, marks
    QColor attention;      ///< shapes: look here
    QColor attentionText;  ///< the same as words
    QColor harm;           ///< shapes: harm done
    QColor harmText;
};

/// The pages that were chosen for the next run (Memory); System if none were.
[[nodiscard]] ThemeChoice rememberedTheme();
void rememberTheme(ThemeChoice choice);

/// Light or dark pages. System asks the palette of the desktop, so call it on a fresh application.
void applyTheme(QApplication& application, ThemeChoice choice);

/// Pages other than the practice room.
[[nodiscard]] QPalette pagePalette(bool dark);
/// The practice room: dark neutral grey in either theme.
[[nodiscard]] QPalette roomPalette();

/// Puts a widget and all it will hold into another room than the application's: palette and style sheet. A style sheet
/// knows the application's palette only, so each room has its own copy of the one sheet. Call before making children.
void dress(QWidget& widget, const QPalette& palette);

[[nodiscard]] bool isDark(const QPalette& palette);
[[nodiscard]] Tones tones(const QPalette& palette);

/// The application's family at one of the sizes above.
[[nodiscard]] QFont typeface(int pixelSize, QFont::Weight weight = QFont::Normal);

/// A thin line between two parts of a page.
[[nodiscard]] QFrame* line(QWidget* parent);

/// The words of a tooltip that may be long: Qt breaks only rich text into lines, all else runs across the screen.
[[nodiscard]] QString brokenIntoLines(const QString& words);

/// Ratio of WCAG 2 between two opaque colours, 1 .. 21.
[[nodiscard]] double contrast(const QColor& a, const QColor& b);

}  // namespace ui::kit
