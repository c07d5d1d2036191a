// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QFont>
#include <QPalette>
#include <QString>

class QApplication;
class QFrame;
class QWidget;

/// The look of all pages: palettes, sizes and one style sheet (ui/assets/cusp.qss).
/// Palette roles have the same meaning everywhere, so that one style sheet serves both rooms and both themes:
///   Window page, Base card, Button control, Mid line, Midlight hovered control, WindowText text,
///   PlaceholderText secondary text, Highlight filled button and slider, Link accent of text and focus ring.
namespace ui::kit {

enum class ThemeChoice { System, Light, Dark };

/// Spacing and corner radius, px.
inline constexpr int kSpace1 = 4;
inline constexpr int kSpace2 = 8;
inline constexpr int kSpace4 = 16;
inline constexpr int kSpace6 = 24;
inline constexpr int kBelowMessagePx = 88;  ///< distance from the top of the view to just below a message
inline constexpr int kRadius = 6;

/// Font sizes, px. kHero is for one number on a page.
inline constexpr int kSmall = 12;
inline constexpr int kBody = 14;
inline constexpr int kTitle = 18;
inline constexpr int kFigure = 28;
inline constexpr int kHero = 72;

/// Colours for which a palette has no role. Shapes have a contrast of 3:1 with their page, text 4.5:1.
struct Tones
{
    QColor accent;         ///< shapes: bars, marks
    QColor attention;      ///< shapes that need attention
    QColor attentionText;  ///< text that needs attention
    QColor harm;           ///< shapes that show harm
    QColor harmText;
};

/// Returns the stored theme; System if none is stored.
[[nodiscard]] ThemeChoice rememberedTheme();
void rememberTheme(ThemeChoice choice);

/// Applies a light or dark palette. System reads the palette of the desktop, so call this on a fresh application.
void applyTheme(QApplication& application, ThemeChoice choice);

/// Returns the palette of all pages but the practice room.
[[nodiscard]] QPalette pagePalette(bool dark);
/// Returns the palette of the practice room: dark neutral grey in both themes.
[[nodiscard]] QPalette roomPalette();

/// Gives a widget and its future children another palette than the application's. The widget needs its own copy of the
/// style sheet, because the application's uses the application's palette. Call before children are created.
void dress(QWidget& widget, const QPalette& palette);

[[nodiscard]] bool isDark(const QPalette& palette);
[[nodiscard]] Tones tones(const QPalette& palette);

/// Returns the application's font family at one of the sizes above.
[[nodiscard]] QFont typeface(int pixelSize, QFont::Weight weight = QFont::Normal);

/// Returns a thin horizontal line between two parts of a page.
[[nodiscard]] QFrame* line(QWidget* parent);

/// Returns a long tooltip as rich text. Qt wraps only rich text; plain text stays on one line.
[[nodiscard]] QString brokenIntoLines(const QString& words);

/// Returns the WCAG 2 contrast ratio of two opaque colours, 1 to 21.
[[nodiscard]] double contrast(const QColor& a, const QColor& b);

}  // namespace ui::kit
