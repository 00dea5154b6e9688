# twrench in a container: docs/install.md#in-a-container
# The first stage builds Debian's package, the second one installs it.
FROM debian:trixie-slim AS build
COPY . /twrench
WORKDIR /twrench
RUN apt-get update && scripts/maintain/package.sh

FROM debian:trixie-slim
COPY --from=build /twrench/out/packages/twrench_*.deb /tmp/
RUN apt-get update \
 && apt-get install --yes --no-install-recommends gnuplot-nox /tmp/twrench_*.deb \
 && rm -rf /var/lib/apt/lists/* /tmp/twrench_*.deb \
 && twrench doctor
WORKDIR /out
ENTRYPOINT ["twrench"]
