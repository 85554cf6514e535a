#!/bin/sh
# Prints without end.
exec yes "more and more"
