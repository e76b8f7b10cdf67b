"""The autopilot of a fixed wing: bank, pitch and throttle for what guidance commands.

Textbook successive loop closure (Stevens, Lewis and Johnson 2016, ch. 4; Beard and McLain 2012, ch. 6). The attitude
loops run inside JSBSim at every step (attitude_hold.xml); altitude and airspeed run here, once a control period.
JSBSim's signs hold in here: right wing down and nose up are positive.
"""

from __future__ import annotations

import math

import jsbsim

from sim.aircraft_file import Aircraft
from sim.jsbsim_model import property_node
from sim.lasting_wind import LastingWind


class Autopilot:
    """Flies bank [rad, right positive], airspeed and altitude from a trimmed `fdm` on, renewed every `period` [s]."""

    def __init__(self, aircraft: Aircraft, fdm: jsbsim.FGFDMExec, period: float) -> None:
        roll, yaw, pitch = aircraft.roll, aircraft.yaw, aircraft.pitch
        gains = {
            "roll-gain": roll.aileron / roll.time,
            "roll-rate-gain": roll.aileron,
            "roll-integral": roll.aileron_integral,
            "yaw-rate-gain": yaw.rudder,
            "yaw-integral": yaw.rudder_integral,
            "yaw-from-aileron": yaw.rudder_from_aileron,
            "pitch-gain": pitch.elevator,
            "pitch-rate-gain": pitch.elevator_rate,
            "pitch-integral": pitch.elevator_integral,
        }
        for name, value in gains.items():
            fdm[f"attitude-hold/{name}"] = value
        self._set_bank = property_node(fdm, "attitude-hold/bank-cmd-rad").set_double_value
        self._set_pitch = property_node(fdm, "attitude-hold/pitch-cmd-rad").set_double_value
        engines = fdm.get_propulsion().get_num_engines()
        throttles = [property_node(fdm, f"fcs/throttle-cmd-norm[{i}]") for i in range(engines)]
        self._set_throttles = [throttle.set_double_value for throttle in throttles]
        self._pitch_gains, self._throttle_gains, self._period = pitch, aircraft.throttle, period
        self._slowest = aircraft.envelope.speed_min
        self._turn_pitch = math.radians(pitch.turn_lift)
        self._bank_step = math.radians(roll.rate_limit) * period
        self._lasting_wind = LastingWind(fdm, aircraft.throttle.wind_time, period)
        # Integrals start at what trim needs
        self._bank, self._pitch_sum = fdm["attitude/phi-rad"], fdm["attitude/theta-rad"]
        self._climb = 0.0
        self._throttle_sum = self.throttle = fdm["fcs/throttle-cmd-norm"]
        self._set_bank(self._bank)
        self._set_pitch(self._pitch_sum)

    def command(
        self, bank: float, bank_now: float, speed: float, airspeed: float, climb_rate: float,
        altitude_error: float, slope_rate: float,
    ) -> None:  # fmt: skip
        """Renew the commands for one period; `speed` [m/s] is the commanded airspeed, `slope_rate` [m/s] of the path.

        The bank command moves at the roll rate limit. Climb rate over airspeed is the flight path angle, so its error
        is a pitch; a turn needs more lift and more power, a climb more power (Lambregts 1984, NTRS 19840012520: thrust
        by total energy), which are fed forward. Airspeed comes before altitude: what is missing beyond a reserve takes
        away from the climb, not from the power for it. It is that of the lasting wind, so that a lull commands no
        descent; below the slowest of the envelope it is that of the moment.
        """
        speed_error = speed - self._lasting_wind.airspeed()
        most = self._bank_step
        self._bank += max(-most, min(most, bank - self._bank))
        self._set_bank(self._bank)
        turn_g = 1.0 / math.cos(bank_now) - 1.0

        gains = self._pitch_gains
        wanted = max(-gains.climb_limit, min(gains.climb_limit, altitude_error / gains.altitude_time)) + slope_rate
        missing = max(0.0, speed_error - gains.speed_reserve, self._slowest - airspeed)
        left = wanted - gains.speed_priority * missing
        most = gains.climb_change * self._period
        self._climb += max(-most, min(most, left - self._climb))
        angle = (self._climb - climb_rate) / airspeed
        self._pitch_sum += gains.climb_integral * angle * self._period
        self._set_pitch(self._pitch_sum + gains.climb * angle + self._turn_pitch * turn_g)

        power = self._throttle_gains
        level = self._throttle_sum + power.gain * speed_error
        level += power.turn_power * turn_g + power.climb_power * wanted / airspeed
        self.throttle = max(0.0, min(1.0, level))
        if level == self.throttle or (level > self.throttle) != (speed_error > 0.0):
            self._throttle_sum += power.integral * speed_error * self._period
        for set_throttle in self._set_throttles:
            set_throttle(self.throttle)
