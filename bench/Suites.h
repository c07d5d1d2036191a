// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include <QList>
#include <QString>
#include <QStringList>

#include "core/base/Result.h"
#include "ui/charts/Chart.h"

/// The measurements of `cusp bench`: one function per suite.
namespace bench {

/// One measured figure.
struct Figure
{
    QString key;  ///< for tools, the same in every version: suite, quantity and unit in snake_case
    QString what;
    double value = 0.0;
    QString unit;
    QString reach;  ///< the goal; empty if there is none
};
using Figures = QList<Figure>;

/// A chart and the name of its files, after "bench-": "contact-ground".
struct NamedChart
{
    QString name;
    ui::charts::Chart chart;
};

/// The parameters of a suite from the command line, and its callbacks.
struct Context
{
    double minutes = 10.0;  ///< for drilling, and for the servo at 4 kHz
    QStringList meshes;     ///< files to load
    /// Reports what is being measured, the steps done and their number.
    std::function<void(const QString& what, int done, int of)> progress;
    /// Receives a chart of the results.
    std::function<void(const NamedChart&)> show;
};

/// Compares the volume of solids at the standard grid with closed form.
[[nodiscard]] core::Result<Figures> volumeSuite(const Context& context);
/// Measures the time from a number or a mesh file to a tooth that can be drilled.
[[nodiscard]] core::Result<Figures> loadSuite(const Context& context);
/// Measures the thread CPU time of a servo tick, by method and grid.
[[nodiscard]] core::Result<Figures> tickSuite(const Context& context);
/// Measures the distance of each method's anchor from its exact place, over surfaces whose offset is known.
[[nodiscard]] core::Result<Figures> contactSuite(const Context& context);
/// Measures the same, and the lag of anchors, against the rate of the servo.
[[nodiscard]] core::Result<Figures> rateSuite(const Context& context);
/// Runs servo, device and hand in scenes where methods fail, and counts the trials in which each method is stable.
[[nodiscard]] core::Result<Figures> stabilitySuite(const Context& context);
/// Measures the volume of swept burs against closed form, the spread of the removal rate over grids, rates and
/// headings, the rates, and the ripple.
[[nodiscard]] core::Result<Figures> cuttingSuite(const Context& context);
/// Compares the height stack with a dense voxel model of the same tooth: size, time, volume.
[[nodiscard]] core::Result<Figures> modelSuite(const Context& context);
/// Measures ticks and memory over minutes of continuous drilling.
[[nodiscard]] core::Result<Figures> drillingSuite(const Context& context);
/// Measures the largest stable stiffness of a simulated Falcon and hand, by method, hand and delay.
[[nodiscard]] core::Result<Figures> stiffnessSuite(const Context& context);

/// Measures the change of the force from tick to tick while a hand is led over a crown.
[[nodiscard]] core::Result<Figures> smoothnessSuite(const Context& context);
/// Measures the servo at 1, 2 and 4 kHz: largest stable stiffness, ticks while a simulated Falcon drills, missed
/// periods.
[[nodiscard]] core::Result<Figures> servoSuite(const Context& context);

/// Measures a simulated person at a mouse: the overshoot of a plunge, the flatness of a slot, the removal of a lesion
/// without the pulp, and the distance of the bur from the pointer.
[[nodiscard]] core::Result<Figures> pointerSuite(const Context& context);

/// Measures the cost of an exchange of packets with a Falcon, and of its kinematics.
[[nodiscard]] core::Result<Figures> falconSuite(const Context& context);

/// Measures head tracking on rendered pictures with known poses: errors, times, losses, the filter, and false tags.
[[nodiscard]] core::Result<Figures> trackingSuite(const Context& context);

/// Measures the sound of the handpiece: computing time, latency, pitch, and the difference between enamel and dentin.
[[nodiscard]] core::Result<Figures> soundSuite(const Context& context);

/// Measures the replay of a recording of continuous drilling, and access to some of its moments.
[[nodiscard]] core::Result<Figures> replaySuite(const Context& context);
/// Compares the program's points with the marks of a strict instructor, for attempts with known errors.
[[nodiscard]] core::Result<Figures> marksSuite(const Context& context);
/// Measures a servo in its thread at 1 kHz, alternately alone and with the live assessment of a lesson, and the cost of
/// that.
[[nodiscard]] core::Result<Figures> liveSuite(const Context& context);
/// Measures the undo history: memory of a thousand moments, jumps between them, and their effect on the servo.
[[nodiscard]] core::Result<Figures> historySuite(const Context& context);

}  // namespace bench
