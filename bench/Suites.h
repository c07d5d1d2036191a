// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include <QList>
#include <QString>
#include <QStringList>

#include "core/base/Result.h"
#include "ui/charts/Chart.h"

/// What `cusp bench` measures: one function a suite.
namespace bench {

/// One measured figure.
struct Figure
{
    QString key;  ///< for tools, the same in every version: suite, what and unit in snake_case
    QString what;
    double value = 0.0;
    QString unit;
    QString reach;  ///< what was to be reached, empty if nothing was set
};
using Figures = QList<Figure>;

/// A chart and the name of its files, after "bench-": "contact-ground".
struct NamedChart
{
    QString name;
    ui::charts::Chart chart;
};

/// What a suite needs from the command line, and where it tells how far it is.
struct Context
{
    double minutes = 10.0;  ///< of drilling, and of the servo at 4 kHz
    QStringList meshes;     ///< files to load
    /// What is being measured now, and how many steps of how many are behind.
    std::function<void(const QString& what, int done, int of)> progress;
    /// Takes a picture of what was measured.
    std::function<void(const NamedChart&)> show;
};

/// Volume of solids at the standard grid against closed form.
[[nodiscard]] core::Result<Figures> volumeSuite(const Context& context);
/// Time from a number or a mesh file to a tooth that can be drilled.
[[nodiscard]] core::Result<Figures> loadSuite(const Context& context);
/// Thread CPU time of a servo tick, by method and grid.
[[nodiscard]] core::Result<Figures> tickSuite(const Context& context);
/// Distance of each method's anchor from where geometry puts it, over surfaces whose offset is known.
[[nodiscard]] core::Result<Figures> contactSuite(const Context& context);
/// The same, and how far anchors lag behind, against the rate of the servo.
[[nodiscard]] core::Result<Figures> rateSuite(const Context& context);
/// What becomes of servo, device and hand in scenes where methods fail: how many trials of each method hold.
[[nodiscard]] core::Result<Figures> stabilitySuite(const Context& context);
/// Volume of swept burs against closed form, spread of the pace over grids, rates and headings, rates, ripple.
[[nodiscard]] core::Result<Figures> cuttingSuite(const Context& context);
/// The height stack beside a dense voxel model of the same tooth: size, time, volume.
[[nodiscard]] core::Result<Figures> modelSuite(const Context& context);
/// Minutes of continuous drilling: ticks and memory.
[[nodiscard]] core::Result<Figures> drillingSuite(const Context& context);
/// Largest stiffness that a simulated Falcon and hand keep still, by method, hand and delay.
[[nodiscard]] core::Result<Figures> stiffnessSuite(const Context& context);

/// Change of the force from tick to tick while a hand is led over a crown.
[[nodiscard]] core::Result<Figures> smoothnessSuite(const Context& context);
/// The servo at 1, 2 and 4 kHz: largest stable stiffness, ticks while a simulated Falcon drills, missed periods.
[[nodiscard]] core::Result<Figures> servoSuite(const Context& context);

/// A simulated person at a mouse: how deep a plunge goes too far, how flat a slot becomes, whether a lesion comes out
/// without the pulp, and how near the bur stays to the pointer.
[[nodiscard]] core::Result<Figures> pointerSuite(const Context& context);

/// What an exchange of packets with a Falcon costs, and its kinematics.
[[nodiscard]] core::Result<Figures> falconSuite(const Context& context);

/// Head tracking on rendered pictures whose poses are known: errors, times, losses, the filter, and false tags.
[[nodiscard]] core::Result<Figures> trackingSuite(const Context& context);

/// Measures the sound of the handpiece: computing time, latency, pitch, and the difference between enamel and dentin.
[[nodiscard]] core::Result<Figures> soundSuite(const Context& context);

/// A recording of continuous drilling played to its end, and looked at here and there.
[[nodiscard]] core::Result<Figures> replaySuite(const Context& context);
/// Points of the program against the letters of a strict instructor, for attempts that were spoiled in a known way.
[[nodiscard]] core::Result<Figures> marksSuite(const Context& context);
/// A servo in its thread at 1 kHz, by turns alone and with the live measures of a lesson beside it, and what those
/// take.
[[nodiscard]] core::Result<Figures> liveSuite(const Context& context);
/// Undo history: memory of a thousand moments, jumps between them, and what they do to the servo.
[[nodiscard]] core::Result<Figures> historySuite(const Context& context);

}  // namespace bench
